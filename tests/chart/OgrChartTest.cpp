#include "seahex/chart/ChartReader.h"

#include "seahex/world/BlockingRule.h"

#include "support/TestCharts.h"

#include <gtest/gtest.h>

#include <ogr_geometry.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// A bay: deep water in the west, shoal water in the east, an island with a lagoon, dangers.
std::vector<TestLayer> bay()
{
    const std::string deep = boxWkt(10.0, 50.0, 10.1, 50.1);
    const std::string shoal = "POLYGON ((10.1 50, 10.2 50, 10.2 50.1, 10.1 50.1, 10.1 50),"
                              "(10.14 50.04, 10.14 50.06, 10.16 50.06, 10.16 50.04, 10.14 50.04))";
    const std::string island = boxWkt(10.14, 50.04, 10.16, 50.06);
    return {{"M_COVR", {{boxWkt(10.0, 50.0, 10.2, 50.1), {{"CATCOV", 1}}}}},
            {"DEPARE", {{deep, {{"DRVAL1", 10.0}, {"DRVAL2", 20.0}}}, {shoal, {{"DRVAL1", 1.5}, {"DRVAL2", 2.0}}}}},
            {"LNDARE", {{island, {{"OBJNAM", std::string("Little Isle")}}}}},
            {"UWTROC",
             {{"POINT (10.05 50.05)", {{"WATLEV", 3}, {"EXPSOU", 1}}},
              {"POINT (10.1 50.05)", {{"WATLEV", 3}, {"EXPSOU", 1}}},
              {"POINT (10.02 50.02)", {{"WATLEV", 5}, {"VALSOU", 0.0}}}}},
            {"SLCONS", {{"LINESTRING (10.16 50.05, 10.17 50.05)", {{"CATSLC", 4}}}}},
            {"RESARE", {{boxWkt(10.01, 50.01, 10.03, 50.03), {{"RESTRN", std::vector<std::string>{"7", "14"}}}}}},
            {"SOUNDG", {{"MULTIPOINT Z ((10.03 50.07 4.5), (10.04 50.08 12.25))", {{"QUASOU", std::string("6")}}}}}};
}

std::vector<const GeoHazard *> ofClass(Chart &&, const std::string &) = delete;  // would point into what is gone

std::vector<const GeoHazard *> ofClass(const Chart &chart, const std::string &objectClass)
{
    std::vector<const GeoHazard *> found;
    for (const GeoHazard &hazard : chart.hazards)
        if (hazard.object->objectClass == objectClass)
            found.push_back(&hazard);
    return found;
}

bool isWarnedOf(const Chart &chart, const std::string &words)
{
    const auto &warnings = chart.cells.at(0).warnings;
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const std::string &warning) { return warning.find(words) != std::string::npos; });
}

std::string ringText(const Ring &ring)
{
    // Formats may turn a ring round or start it elsewhere.
    std::vector<std::string> corners;
    for (std::size_t i = 1; i < ring.size(); ++i)
        corners.push_back(std::to_string(ring[i].x()) + " " + std::to_string(ring[i].y()));
    std::sort(corners.begin(), corners.end());
    std::string text = "(";
    for (const std::string &corner : corners)
        text += corner + ",";
    return text + ")";
}

/// A hazard with all that must not depend on the format.
std::string textOf(const GeoHazard &hazard)
{
    HazardObject object = *hazard.object;
    object.featureId.clear();
    object.cell.clear();
    std::ostringstream text;
    text << describe(object) << " radius " << object.radiusM << " beneath " << object.surroundingDepthM.value_or(-99)
         << " ";
    for (const Point &point : hazard.shape.lonLat.points)
        text << "P" << std::to_string(point.x()) << " " << std::to_string(point.y());
    for (const LineString &line : hazard.shape.lonLat.lines)
        for (const Point &point : line)
            text << "L" << std::to_string(point.x()) << " " << std::to_string(point.y());
    for (const Polygon &area : hazard.shape.lonLat.areas)
    {
        text << ringText(area.outer());
        for (const Ring &hole : area.inners())
            text << "hole" << ringText(hole);
    }
    return text.str();
}

std::vector<std::string> textsOf(const Chart &chart)
{
    std::vector<std::string> texts;
    for (const GeoHazard &hazard : chart.hazards)
        texts.push_back(textOf(hazard));
    std::sort(texts.begin(), texts.end());
    return texts;
}

TEST(OgrChart, readsTheSameFromEveryFormat)
{
    const TemporaryFolder folder;
    writeChart(folder / "bay.gpkg", bay(), TestFormat::GeoPackage);
    writeChart(folder / "json", bay(), TestFormat::GeoJson);
    writeChart(folder / "shape", bay(), TestFormat::Shapefile);
    const Chart package = readChart((folder / "bay.gpkg").string());
    const std::vector<std::string> texts = textsOf(package);
    EXPECT_EQ(texts.size(), 10u);
    EXPECT_EQ(textsOf(readChart((folder / "json").string())), texts);
    EXPECT_EQ(textsOf(readChart((folder / "shape").string())), texts);

    EXPECT_EQ(package.cells.at(0).name, "bay");
    EXPECT_EQ(package.cells.at(0).groupOne.twiceAreaDifference, "0");
    EXPECT_TRUE(package.cells.at(0).warnings.empty()) << package.cells.at(0).warnings.front();
}

TEST(OgrChart, poolsSingleLayersIntoOneCell)
{
    const TemporaryFolder folder;
    writeChart(folder / "json", bay(), TestFormat::GeoJson);
    std::vector<std::string> files;
    for (const TestLayer &layer : bay())
        files.push_back((folder / "json" / (layer.name + ".geojson")).string());
    const Chart chart = readChart(files);
    EXPECT_EQ(chart.cells.size(), 1u);
    EXPECT_EQ(textsOf(chart), textsOf(readChart((folder / "json").string())));
}

TEST(OgrChart, takesTheNameOfAGeoJsonLayerFromItsMember)
{
    const TemporaryFolder folder;
    const std::string square = "[[[10,50],[10.1,50],[10.1,50.1],[10,50.1],[10,50]]]";
    writeBytes(
        folder / "anything.geojson",
        R"({"type":"FeatureCollection","name":"depare","features":[{"type":"Feature","properties":{"drval1":"5"},)"
        R"("geometry":{"type":"Polygon","coordinates":)" +
            square + "}}]}");
    const Chart chart = readChart((folder / "anything.geojson").string());
    ASSERT_EQ(chart.hazards.size(), 1u);
    EXPECT_EQ(chart.hazards[0].object->objectClass, "DEPARE");
    EXPECT_EQ(chart.hazards[0].object->value("DRVAL1"), 5.0);
    EXPECT_EQ(chart.cells.at(0).name, "anything");
}

TEST(OgrChart, keepsAttributesListsNamesAndDepths)
{
    const TemporaryFolder folder;
    writeChart(folder / "bay.gpkg", bay());
    const Chart chart = readChart((folder / "bay.gpkg").string());
    EXPECT_EQ(ofClass(chart, "LNDARE").at(0)->object->name, "Little Isle");
    EXPECT_TRUE(ofClass(chart, "RESARE").at(0)->object->has("RESTRN", 7));
    EXPECT_TRUE(ofClass(chart, "RESARE").at(0)->object->has("RESTRN", 14));
    const auto soundings = ofClass(chart, "SOUNDG");
    ASSERT_EQ(soundings.size(), 2u);
    EXPECT_EQ(soundings[0]->object->value("DEPTH"), 4.5);
    EXPECT_EQ(soundings[1]->object->value("DEPTH"), 12.25);
    EXPECT_DOUBLE_EQ(ofClass(chart, "SLCONS").at(0)->object->radiusM, 10.0);
    EXPECT_DOUBLE_EQ(ofClass(chart, "LNDARE").at(0)->object->radiusM, 0.0);
}

TEST(OgrChart, takesTheLeastDepthBeneathADangerTouchesIncluded)
{
    const TemporaryFolder folder;
    std::vector<TestLayer> layers = bay();
    writeChart(folder / "bay.gpkg", layers);
    const Chart chart = readChart((folder / "bay.gpkg").string());
    const auto rocks = ofClass(chart, "UWTROC");
    EXPECT_EQ(rocks.at(0)->object->surroundingDepthM, 10.0);
    EXPECT_EQ(rocks.at(1)->object->surroundingDepthM, 1.5) << "the rock lies on the boundary of shoal water";
    EXPECT_FALSE(judge(*rocks.at(0)->object, Vessel{}).blocks());
    EXPECT_TRUE(judge(*rocks.at(1)->object, Vessel{}).blocks());

    layers.push_back({"UNSARE", {{boxWkt(10.04, 50.04, 10.06, 50.06), {}}}});
    writeChart(folder / "unsurveyed.gpkg", layers);
    const Chart unsurveyed = readChart((folder / "unsurveyed.gpkg").string());
    EXPECT_FALSE(ofClass(unsurveyed, "UWTROC").at(0)->object->surroundingDepthM.has_value());
}

TEST(OgrChart, blocksWhereGroupOneLeavesAGap)
{
    const TemporaryFolder folder;
    std::vector<TestLayer> layers = bay();
    layers.erase(layers.begin() + 2);  // the island
    writeChart(folder / "gap.gpkg", layers);
    const Chart chart = readChart((folder / "gap.gpkg").string());
    const GroupOneCheck &check = chart.cells.at(0).groupOne;
    EXPECT_TRUE(check.applicable);
    EXPECT_FALSE(check.tiles);
    EXPECT_EQ(check.twiceAreaDifference, "80000000000");  // twice (0.02 degrees * 1e7) squared
    EXPECT_NEAR(check.gapFraction, 0.02, 1e-9);
    EXPECT_TRUE(isWarnedOf(chart, "do not tile"));

    std::vector<const GeoHazard *> gaps;
    for (const GeoHazard &hazard : chart.hazards)
        if (hazard.object->rule == HazardRule::ChartGap)
            gaps.push_back(&hazard);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_EQ(ringText(gaps[0]->shape.lonLat.areas.at(0).outer()),
              "(10.140000 50.040000,10.140000 50.060000,10.160000 50.040000,10.160000 50.060000,)");
    EXPECT_TRUE(judge(*gaps[0]->object, Vessel{}).blocks());
}

TEST(OgrChart, takesTheCoverageOfGroupOneWhereThereIsNoOther)
{
    const TemporaryFolder folder;
    std::vector<TestLayer> layers = bay();
    layers.erase(layers.begin());
    writeChart(folder / "open.gpkg", layers);
    const Chart chart = readChart((folder / "open.gpkg").string());
    EXPECT_FALSE(chart.cells.at(0).groupOne.applicable);
    EXPECT_TRUE(isWarnedOf(chart, "that of its areas of group 1 is taken"));
    ASSERT_EQ(chart.coverage.lonLat.areas.size(), 1u);
    EXPECT_TRUE(chart.coverage.lonLat.areas[0].inners().empty());
    EXPECT_DOUBLE_EQ(chart.bounds.eastDeg, 10.2);
}

TEST(OgrChart, readsListsInEveryNotation)
{
    const TemporaryFolder folder;
    for (const char *notation : {"7,14", "(2:7,14)", "[ \"7\", \"14\" ]", "[7, 14]", " 7 , 14 ", "7;14"})
    {
        std::vector<TestLayer> layers = bay();
        layers[5].features[0].attributes = {{"restrn", std::string(notation)}};
        const std::string path = (folder / "list.gpkg").string();
        std::filesystem::remove(path);
        writeChart(path, layers);
        const Chart chart = readChart(path);
        const HazardObject &area = *ofClass(chart, "RESARE").at(0)->object;
        EXPECT_TRUE(area.has("RESTRN", 7) && area.has("RESTRN", 14)) << notation;
        EXPECT_FALSE(area.has("RESTRN", 2)) << notation;
    }
}

TEST(OgrChart, countsWhatIsNoNumberAsUnknown)
{
    const TemporaryFolder folder;
    for (const char *text : {"deep", "12 ft", "nan", "inf", "-", ""})
    {
        std::vector<TestLayer> layers = bay();
        layers[3].features = {{"POINT (10.05 50.05)", {{"VALSOU", std::string(text)}, {"WATLEV", std::string("3")}}}};
        const std::string path = (folder / "odd.gpkg").string();
        std::filesystem::remove(path);
        writeChart(path, layers);
        const Chart chart = readChart(path);
        const HazardObject &rock = *ofClass(chart, "UWTROC").at(0)->object;
        EXPECT_FALSE(rock.value("VALSOU").has_value()) << text;
        EXPECT_EQ(rock.value("WATLEV"), 3.0);
        EXPECT_TRUE(judge(rock, Vessel{}).blocks());
    }
}

TEST(OgrChart, readsSoundingsByFieldOrHeightOrBlocks)
{
    const TemporaryFolder folder;
    std::vector<TestLayer> layers = bay();
    layers[6].features = {{"POINT (10.03 50.07)", {{"DEPTH", 7.5}}},
                          {"POINT Z (10.03 50.08 2.5)", {{"DEPTH", 9.5}}},
                          {"POINT Z (10.03 50.09 3.5)", {}},
                          {"POINT (10.04 50.09)", {}}};
    writeChart(folder / "soundings.gpkg", layers);
    const Chart chart = readChart((folder / "soundings.gpkg").string());
    const auto soundings = ofClass(chart, "SOUNDG");
    ASSERT_EQ(soundings.size(), 4u);
    EXPECT_EQ(soundings[0]->object->value("DEPTH"), 7.5);
    EXPECT_EQ(soundings[1]->object->value("DEPTH"), 9.5);
    EXPECT_EQ(soundings[2]->object->value("DEPTH"), 3.5);
    EXPECT_FALSE(soundings[3]->object->value("DEPTH").has_value());
    EXPECT_TRUE(judge(*soundings[3]->object, Vessel{}).blocks());
}

TEST(OgrChart, takesMixedAndCurvedGeometries)
{
    const TemporaryFolder folder;
    std::vector<TestLayer> layers = bay();
    layers.push_back(
        {"obstrn",
         {{"GEOMETRYCOLLECTION (POINT (10.01 50.05), LINESTRING Z (10.01 50.06 1, 10.02 50.06 2), "
           "POLYGON ((10.01 50.07, 10.02 50.07, 10.02 50.08, 10.01 50.07)))",
           {{"VALSOU", 1.0}}},
          {"CURVEPOLYGON (CIRCULARSTRING (10.05 50.02, 10.06 50.03, 10.07 50.02, 10.06 50.01, 10.05 50.02))",
           {{"VALSOU", 1.0}}},
          {"MULTIPOLYGON (((10.08 50.01, 10.09 50.01, 10.09 50.02, 10.08 50.01)),"
           "((10.08 50.03, 10.09 50.03, 10.09 50.04, 10.08 50.03)))",
           {{"VALSOU", 1.0}}}}});
    writeChart(folder / "mixed.gpkg", layers);
    const Chart chart = readChart((folder / "mixed.gpkg").string());
    const auto found = ofClass(chart, "OBSTRN");
    ASSERT_EQ(found.size(), 3u);
    const Shape &mixed = found[0]->shape.lonLat;
    EXPECT_EQ(mixed.points.size(), 1u);
    EXPECT_EQ(mixed.lines.size(), 1u);
    EXPECT_EQ(mixed.areas.size(), 1u);
    EXPECT_DOUBLE_EQ(found[0]->object->radiusM, 10.0);
    EXPECT_EQ(found[2]->shape.lonLat.areas.size(), 2u);

    const Ring &circle = found[1]->shape.lonLat.areas.at(0).outer();
    EXPECT_GT(circle.size(), 100u);
    EXPECT_EQ(circle.front(), circle.back());
    for (const Point &corner : circle)
        EXPECT_NEAR((corner - Point(10.06, 50.02)).norm(), 0.01, 1e-9);
}

TEST(OgrChart, turnsOtherCoordinateSystemsIntoDegrees)
{
    // The bay's corners in UTM zone 32 north, as PROJ has them.
    OGRSpatialReference degrees;
    OGRSpatialReference utm;
    degrees.importFromEPSG(4326);
    utm.importFromEPSG(32632);
    degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    utm.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> toUtm(OGRCreateCoordinateTransformation(&degrees, &utm));
    ASSERT_NE(toUtm, nullptr);
    const auto inUtm = [&](const std::string &wkt)
    {
        OGRGeometry *raw = nullptr;
        OGRGeometryFactory::createFromWkt(wkt.c_str(), nullptr, &raw);
        const std::unique_ptr<OGRGeometry> geometry(raw);
        geometry->transform(toUtm.get());
        OGRWktOptions options;
        options.precision = 12;
        return geometry->exportToWkt(options);
    };
    std::vector<TestLayer> layers = bay();
    // An edge that is straight in one frame is bent in the other, so areas must share their corners, not only their
    // edges.
    layers[0].features[0].wkt = "POLYGON ((10 50, 10.1 50, 10.2 50, 10.2 50.1, 10.1 50.1, 10 50.1, 10 50))";
    for (TestLayer &layer : layers)
        for (TestFeature &feature : layer.features)
            feature.wkt = inUtm(feature.wkt);

    const TemporaryFolder folder;
    writeChart(folder / "utm.gpkg", layers, TestFormat::GeoPackage, 32632);
    const Chart chart = readChart((folder / "utm.gpkg").string());
    EXPECT_NEAR(chart.bounds.westDeg, 10.0, 1e-5);
    EXPECT_NEAR(chart.bounds.northDeg, 50.1, 1e-3);
    EXPECT_LT((ofClass(chart, "UWTROC").at(0)->shape.lonLat.points.at(0) - Point(10.05, 50.05)).norm(), 1e-7);
    // An edge that is straight in UTM is none in degrees, so it has got corners.
    EXPECT_GT(ofClass(chart, "DEPARE").at(0)->shape.lonLat.areas.at(0).outer().size(), 20u);
    for (const GeoHazard &hazard : chart.hazards)
        EXPECT_NE(hazard.object->rule, HazardRule::ChartGap) << chart.cells.at(0).warnings.front();
}

TEST(OgrChart, warnsOfLayersThatItCantPlace)
{
    const TemporaryFolder folder;
    std::vector<TestLayer> layers = bay();
    layers.push_back({"harbour_walls", {{"LINESTRING (10 50, 10.1 50.1)", {}}}});
    layers.push_back({"LIGHTS", {{"POINT (10.05 50.05)", {}}}});
    writeChart(folder / "more.gpkg", layers);
    const Chart chart = readChart((folder / "more.gpkg").string());
    EXPECT_TRUE(isWarnedOf(chart, "layer harbour_walls"));
    EXPECT_EQ(chart.cells.at(0).skipped.at("class without a rule").at("LIGHTS"), 1u);

    writeChart(folder / "shape", bay(), TestFormat::Shapefile, 0);
    const Chart unplaced = readChart((folder / "shape").string());
    EXPECT_TRUE(isWarnedOf(unplaced, "names no coordinate system"));
    EXPECT_EQ(textsOf(unplaced).size(), 10u);
}

}  // namespace
