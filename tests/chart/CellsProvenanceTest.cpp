// Cells of equal provenance are equal: whatever goes into them changes the text, and what does not leaves it.

#include "seahex/chart/CellsProvenance.h"

#include "seahex/chart/ChartArena.h"
#include "seahex/chart/ChartError.h"
#include "seahex/chart/ChartReader.h"

#include "support/RunProgram.h"
#include "support/TestCharts.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

using namespace seahex;
using namespace seahex::test;

namespace fs = std::filesystem;

namespace
{

std::vector<TestLayer> layersWith(double shoalM)
{
    return {{"M_COVR", {{boxWkt(10.0, 50.0, 10.1, 50.1), {{"CATCOV", 1}}}}},
            {"DEPARE",
             {{boxWkt(10.0, 50.0, 10.1, 50.05), {{"DRVAL1", 10.0}, {"DRVAL2", 20.0}}},
              {boxWkt(10.0, 50.05, 10.1, 50.1), {{"DRVAL1", shoalM}, {"DRVAL2", 20.0}}}}},
            {"WRECKS",
             {{"POINT (10.05 50.02)", {{"VALSOU", 1.0}, {"WATLEV", 3}}},
              {"POINT (10.07 50.03)", {{"VALSOU", 9.0}, {"WATLEV", 3}}}}}};
}

/// All that goes into cells.
struct Ingredients
{
    Chart chart;
    Vessel vessel = {};
    HazardScope scope = HazardScope::All;
    Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(50.05, 10.05));
    Lattice lattice = HexLattice(Point(-4000.0, 6000.0), 100.0, 80, 130);

    std::string provenance() const { return cellsProvenance(chart, vessel, scope, projection, lattice); }
};

class CellsProvenance : public testing::Test
{
protected:
    CellsProvenance()
    {
        writeChart(path_, layersWith(1.0));
        cells_.chart = readChart(path_.string());
        texts_.insert(cells_.provenance());
    }

    /// Cells made with the change have a provenance that no other change gave.
    void expectOther(const char *what, const std::function<void(Ingredients &)> &change)
    {
        Ingredients changed = cells_;
        change(changed);
        EXPECT_TRUE(texts_.insert(changed.provenance()).second) << what;
    }

    GeoHazard &wreck(Chart &chart, double valsou) const
    {
        for (GeoHazard &hazard : chart.hazards)
            if (hazard.object->objectClass == "WRECKS" && hazard.object->value("VALSOU") == valsou)
                return hazard;
        throw std::runtime_error("the chart has lost its wreck");
    }

    TemporaryFolder folder_;
    fs::path path_ = folder_ / "small.gpkg";
    Ingredients cells_;
    std::set<std::string> texts_;
};

TEST_F(CellsProvenance, isTheSameOnEveryReadingAndInEveryFolder)
{
    EXPECT_EQ(cells_.provenance(), *texts_.begin());
    fs::create_directory(folder_ / "moved");
    fs::copy_file(path_, folder_ / "moved" / "small.gpkg");
    fs::remove(path_);
    cells_.chart = readChart((folder_ / "moved" / "small.gpkg").string());
    EXPECT_EQ(cells_.provenance(), *texts_.begin());
}

TEST_F(CellsProvenance, holdsEveryPropertyOfTheVessel)
{
    for (double Vessel::*property :
         {&Vessel::draughtM, &Vessel::underKeelClearanceM, &Vessel::airDraughtM, &Vessel::beamM, &Vessel::marginM})
        expectOther("a property of the vessel", [property](Ingredients &cells)
                    { cells.vessel.*property = std::nextafter(cells.vessel.*property, 100.0); });
}

TEST_F(CellsProvenance, holdsScopeProjectionAndLattice)
{
    for (const HazardScope scope :
         {HazardScope::LandOnly, HazardScope::WaterColumn, HazardScope::WaterColumnAboveCables})
        expectOther("scope", [scope](Ingredients &cells) { cells.scope = scope; });

    const double nearlyDeg = std::nextafter(50.05, 51.0);
    for (const Projection &projection :
         {Projection::plateCarree(), Projection::transverseMercator(GeoPoint::fromLatLon(nearlyDeg, 10.05)),
          Projection::transverseMercator(GeoPoint::fromLatLon(50.05, std::nextafter(10.05, 11.0))),
          Projection::localEquirectangular(GeoPoint::fromLatLon(50.05, 10.05)),
          Projection::localEquirectangular(GeoPoint::fromLatLon(nearlyDeg, 10.05))})
        expectOther("projection", [&projection](Ingredients &cells) { cells.projection = projection; });

    const Point corner(-4000.0, 6000.0);
    for (const Lattice &lattice :
         {Lattice(HexLattice(Point(std::nextafter(-4000.0, 0.0), 6000.0), 100.0, 80, 130)),
          Lattice(HexLattice(Point(-4000.0, std::nextafter(6000.0, 0.0)), 100.0, 80, 130)),
          Lattice(HexLattice(corner, std::nextafter(100.0, 0.0), 80, 130)), Lattice(HexLattice(corner, 100.0, 81, 130)),
          Lattice(HexLattice(corner, 100.0, 80, 131)), Lattice(SquareLattice(corner, 100.0, 80, 130))})
        expectOther("lattice", [&lattice](Ingredients &cells) { cells.lattice = lattice; });
}

TEST_F(CellsProvenance, holdsWhatBlocksToTheLastBitWhateverTheFilesSay)
{
    expectOther("a wreck moved",
                [this](Ingredients &cells)
                {
                    double &x = wreck(cells.chart, 1.0).shape.lonLat.points.front().x();
                    x = std::nextafter(x, 11.0);
                });
    expectOther("a wreck with another radius",
                [this](Ingredients &cells)
                {
                    GeoHazard &hazard = wreck(cells.chart, 1.0);
                    HazardObject object = *hazard.object;
                    object.radiusM = std::nextafter(object.radiusM, 100.0);
                    hazard.object = std::make_shared<const HazardObject>(object);
                });
    expectOther("a wreck that is judged otherwise",
                [this](Ingredients &cells)
                {
                    GeoHazard &hazard = wreck(cells.chart, 9.0);
                    HazardObject object = *hazard.object;
                    object.rule = HazardRule::Always;
                    hazard.object = std::make_shared<const HazardObject>(object);
                });
    expectOther("a hazard taken away", [this](Ingredients &cells) { wreck(cells.chart, 1.0).shape.lonLat = {}; });
    expectOther("less coverage",
                [](Ingredients &cells)
                {
                    double &x = cells.chart.coverage.lonLat.areas.front().outer()[1].x();
                    x = std::nextafter(x, 0.0);
                });
    expectOther("a hole in the coverage",
                [](Ingredients &cells) { cells.chart.coverage.lonLat.areas.front().inners().emplace_back(); });

    Ingredients deep = cells_;
    wreck(deep.chart, 9.0).shape.lonLat.points.front().x() = 10.01;
    EXPECT_EQ(deep.provenance(), *texts_.begin()) << "a wreck that does not block is no part of the cells";
}

TEST_F(CellsProvenance, holdsEveryByteOfAChartsFile)
{
    const fs::path file = folder_ / "cell.000";
    std::string bytes = readBytes(fs::path(SEAHEX_MAPS_DIR) / "sanya.000");
    writeBytes(file, bytes);
    cells_.chart = readChart(file.string());
    const std::string before = cells_.provenance();
    EXPECT_NE(before.find("cell.000, " + std::to_string(bytes.size()) + " bytes"), std::string::npos) << before;

    // Its date of issue says nothing of where water is, and still the file is another one.
    const std::string date = cells_.chart.cells.front().issueDate;
    ASSERT_EQ(date.size(), 8u);
    char &digit = bytes.at(bytes.find(date) + 7);
    digit = digit == '1' ? '2' : '1';
    writeBytes(file, bytes);
    cells_.chart = readChart(file.string());
    EXPECT_NE(cells_.provenance(), before);
}

TEST_F(CellsProvenance, holdsTheUpdatesOfACell)
{
    SEAHEX_TEST_DATA_OR_SKIP(generated, "charts/generated");
    for (const char *name : {"ZZ3NORWY.000", "ZZ3NORWY.001"})
        fs::copy_file(generated / name, folder_ / name);
    cells_.chart = readChart((folder_ / "ZZ3NORWY.000").string());
    const std::string updated = cells_.provenance();
    EXPECT_NE(updated.find("ZZ3NORWY.001"), std::string::npos) << updated;
    fs::remove(folder_ / "ZZ3NORWY.001");
    cells_.chart = readChart((folder_ / "ZZ3NORWY.000").string());
    EXPECT_NE(cells_.provenance(), updated);
}

TEST_F(CellsProvenance, holdsTheSideFilesOfAShapefile)
{
    const auto read = [this](const std::string &name, double shoalM)
    {
        writeChart(folder_ / name, layersWith(shoalM), TestFormat::Shapefile);
        cells_.chart = readChart((folder_ / name).string());
        return cells_.provenance();
    };
    const std::string shoal = read("shoal", 1.0);
    for (const char *file : {"DEPARE.shp", "DEPARE.dbf", "DEPARE.shx", "WRECKS.dbf"})
        EXPECT_NE(shoal.find(file), std::string::npos) << shoal;
    EXPECT_NE(read("deeper", 1.5), shoal) << "1.5 m blocks as 1 m does, but the depths lie in the .dbf";
    EXPECT_EQ(readBytes(folder_ / "shoal/DEPARE.shp"), readBytes(folder_ / "deeper/DEPARE.shp"));
}

TEST_F(CellsProvenance, needsTheFilesOfTheChart)
{
    fs::remove(path_);
    EXPECT_THROW(cells_.provenance(), ChartUnreadable);
}

TEST_F(CellsProvenance, arenasWithAFileAreThoseWithout)
{
    ArenaOptions options;
    options.pitch = 60.0;
    options.cells = folder_ / "cells";
    for (const double draughtM : {1.2, 0.2, 12.0, 0.2})
    {
        options.vessel.draughtM = draughtM;
        ArenaOptions without = options;
        without.cells.clear();
        const ChartArena plain(cells_.chart, without);
        EXPECT_FALSE(plain.isFromFile());
        for (const bool isSecond : {false, true})
        {
            const ChartArena arena(cells_.chart, options);
            EXPECT_EQ(arena.isFromFile(), isSecond) << draughtM;
            EXPECT_TRUE(arena.warnings().empty());
            EXPECT_EQ(arena.occupancy()->words(), plain.occupancy()->words()) << draughtM;
            EXPECT_EQ(arena.occupancy()->lattice(), plain.occupancy()->lattice());
            EXPECT_EQ(arena.hazards().size(), plain.hazards().size());
        }
    }
}

/// The header that the build makes of the sources of a small tree.
class CodeDigest : public testing::Test
{
protected:
    CodeDigest()
    {
        for (const char *room : {"src/world", "src/search", "include/seahex/world"})
            fs::create_directories(folder_.path() / room);
        writeBytes(folder_ / "src/world/Rule.cpp", "return depth < needed;");
        writeBytes(folder_ / "include/seahex/world/Rule.h", "bool blocks();");
        writeBytes(folder_ / "src/search/Search.cpp", "while (true);");
    }

    std::string header() const
    {
        const ProgramResult result =
            runProgram({SEAHEX_CMAKE, "-DROOT=" + folder_.path().string(), "-DROOMS=geometry,world", "-DVERSION=1.2.3",
                        "-DHEADER=" + (folder_ / "Digest.h").string(), "-P", SEAHEX_DIGEST_SCRIPT});
        EXPECT_EQ(result.exitCode, 0) << result.summary();
        return readBytes(folder_ / "Digest.h");
    }

    TemporaryFolder folder_;
};

TEST_F(CodeDigest, changesWithEveryFileOfItsRooms)
{
    std::set<std::string> headers{header()};
    EXPECT_EQ(header(), *headers.begin());
    EXPECT_NE(header().find("1.2.3"), std::string::npos);
    writeBytes(folder_ / "src/search/Search.cpp", "while (false);");
    EXPECT_EQ(header(), *headers.begin()) << "the search fills no cells";
    writeBytes(folder_ / "src/world/Rule.cpp", "return depth <= needed;");
    EXPECT_TRUE(headers.insert(header()).second);
    writeBytes(folder_ / "include/seahex/world/Rule.h", "bool Blocks();");
    EXPECT_TRUE(headers.insert(header()).second);
    fs::rename(folder_ / "src/world/Rule.cpp", folder_ / "src/world/Law.cpp");
    EXPECT_TRUE(headers.insert(header()).second);
    writeBytes(folder_ / "src/world/More.h", "");
    EXPECT_TRUE(headers.insert(header()).second);
}

}  // namespace
