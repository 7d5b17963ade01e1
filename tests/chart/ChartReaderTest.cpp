#include "seahex/chart/ChartReader.h"

#include "seahex/chart/ChartError.h"
#include "seahex/chart/HazardCatalogue.h"

#include "support/TestCharts.h"
#include "support/TestData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <vector>

using namespace seahex;
using seahex::test::TemporaryFolder;

namespace fs = std::filesystem;

namespace
{

std::vector<const GeoHazard *> ofClass(const Chart &chart, const std::string &objectClass)
{
    std::vector<const GeoHazard *> found;
    for (const GeoHazard &hazard : chart.hazards)
        if (hazard.object->objectClass == objectClass)
            found.push_back(&hazard);
    return found;
}

double areaOf(const Ring &ring)
{
    double twice = 0.0;
    for (std::size_t i = 1; i < ring.size(); ++i)
        twice += ring[i - 1].x() * ring[i].y() - ring[i].x() * ring[i - 1].y();
    return std::abs(0.5 * twice);
}

double areaOf(const Shape &shape)
{
    double sum = 0.0;
    for (const Polygon &area : shape.areas)
    {
        sum += areaOf(area.outer());
        for (const Ring &hole : area.inners())
            sum -= areaOf(hole);
    }
    return sum;
}

std::size_t skippedCount(const CellReport &report)
{
    std::size_t count = 0;
    for (const auto &[reason, classes] : report.skipped)
        for (const auto &[objectClass, number] : classes)
            count += number;
    return count;
}

bool isWarnedOf(const CellReport &report, const std::string &words)
{
    return std::any_of(report.warnings.begin(), report.warnings.end(),
                       [&](const std::string &warning) { return warning.find(words) != std::string::npos; });
}

/// What the maker of a generated cell wrote into it.
class GeneratedCell : public testing::TestWithParam<const char *>
{
protected:
    void SetUp() override
    {
        SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
        cell_ = charts / "generated" / (std::string(GetParam()) + ".000");
        fs::path expectation = cell_;
        std::ifstream(expectation.replace_extension(".expect.json")) >> expected_;
        // Without the updates that lie beside it.
        fs::copy_file(cell_, folder_ / cell_.filename().string());
        chart_ = readChart((folder_ / cell_.filename().string()).string());
    }

    TemporaryFolder folder_;
    fs::path cell_;
    nlohmann::json expected_;
    Chart chart_;
};

TEST_P(GeneratedCell, holdsTheAreasOfItsMaker)
{
    std::map<std::string, std::vector<nlohmann::json>> wanted;
    for (const auto &area : expected_["areas"])
        wanted[area[0]].push_back(area);
    ASSERT_FALSE(wanted.empty());
    for (const auto &[objectClass, areas] : wanted)
    {
        if (const HazardClass *row = findHazardClass(objectClass); row == nullptr || row->rule == HazardRule::Ignored)
            continue;
        std::vector<const GeoHazard *> found;
        for (const GeoHazard *hazard : ofClass(chart_, objectClass))
            if (!hazard->shape.lonLat.areas.empty())
                found.push_back(hazard);
        ASSERT_EQ(found.size(), areas.size()) << objectClass;
        for (std::size_t i = 0; i < areas.size(); ++i)
        {
            EXPECT_NEAR(areaOf(found[i]->shape.lonLat), areas[i][2].get<double>(), 1e-11) << objectClass << " " << i;
            for (const char *acronym : {"DRVAL1", "DRVAL2"})
                if (areas[i][1].contains(acronym))
                {
                    EXPECT_EQ(found[i]->object->value(acronym), areas[i][1][acronym].get<double>());
                }
        }
    }
}

TEST_P(GeneratedCell, holdsTheDangersOfItsMaker)
{
    std::map<std::string, std::vector<nlohmann::json>> wanted;
    for (const auto &point : expected_["points"])
        wanted[point[0]].push_back(point);
    ASSERT_EQ(wanted.size(), 3u);
    for (const auto &[objectClass, points] : wanted)
    {
        std::vector<const GeoHazard *> found;
        for (const GeoHazard *hazard : ofClass(chart_, objectClass))
            if (!hazard->shape.lonLat.points.empty())
                found.push_back(hazard);
        ASSERT_EQ(found.size(), points.size()) << objectClass;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const Point where(points[i][2], points[i][3]);
            EXPECT_LT((found[i]->shape.lonLat.points.at(0) - where).norm(), 1e-9) << objectClass << " " << i;
            EXPECT_DOUBLE_EQ(found[i]->object->radiusM, 10.0);
            for (const char *acronym : {"VALSOU", "WATLEV", "CATWRK", "CATOBS"})
            {
                const auto &attributes = points[i][1];
                EXPECT_EQ(found[i]->object->value(acronym), attributes.contains(acronym)
                                                                ? std::optional(attributes[acronym].get<double>())
                                                                : std::nullopt)
                    << describe(*found[i]->object);
            }
        }
    }
}

TEST_P(GeneratedCell, holdsEverySoundingWithItsDepth)
{
    std::vector<nlohmann::json> wanted;
    for (const auto &multipoint : expected_["soundings"])
        wanted.insert(wanted.end(), multipoint.begin(), multipoint.end());
    const auto found = ofClass(chart_, "SOUNDG");
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
        ASSERT_TRUE(found[i]->object->value("DEPTH").has_value());
        // The cell holds decimetres.
        EXPECT_NEAR(*found[i]->object->value("DEPTH"), std::round(10.0 * wanted[i][2].get<double>()) / 10.0, 1e-9);
        EXPECT_LT((found[i]->shape.lonLat.points.at(0) - Point(wanted[i][0], wanted[i][1])).norm(), 1e-9);
    }
}

TEST_P(GeneratedCell, isTiledAndCountsEveryFeatureOnce)
{
    ASSERT_EQ(chart_.cells.size(), 1u);
    const CellReport &report = chart_.cells.front();
    EXPECT_EQ(report.name, GetParam());
    EXPECT_EQ(report.edition, 1);
    EXPECT_EQ(report.update, 0);
    EXPECT_TRUE(report.groupOne.applicable);
    EXPECT_TRUE(report.groupOne.tiles);
    EXPECT_EQ(report.groupOne.twiceAreaDifference, "0");
    EXPECT_EQ(report.featuresRead, report.featuresUsed + skippedCount(report));
    EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();

    const auto &window = expected_["window"];
    EXPECT_NEAR(chart_.bounds.westDeg, window[0].get<double>(), 1e-9);
    EXPECT_NEAR(chart_.bounds.southDeg, window[1].get<double>(), 1e-9);
    EXPECT_NEAR(chart_.bounds.eastDeg, window[2].get<double>(), 1e-9);
    EXPECT_NEAR(chart_.bounds.northDeg, window[3].get<double>(), 1e-9);
    EXPECT_TRUE(chart_.bounds.contains(chart_.bounds.centre()));
    EXPECT_GT(chart_.readMs, 0.0);
}

INSTANTIATE_TEST_SUITE_P(ChartReader, GeneratedCell, testing::Values("ZZ4SHCHN", "ZZ4SANYA"),
                         [](const auto &cell) { return std::string(cell.param); });

TEST(ChartReader, appliesInsertionsDeletionsAndChanges)
{
    SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
    const Chart base = readChart((charts / "generated/ZZ4SHCHN.000").string());
    const Chart updated = readChart((charts / "generated/with_updates/ZZ4SHCHN.000").string());
    EXPECT_EQ(updated.cells.front().update, 2);

    const auto named = [&](const Chart &chart)
    {
        return std::count_if(chart.hazards.begin(), chart.hazards.end(),
                             [](const GeoHazard &hazard) { return hazard.object->name.rfind("UPDATE WRECK", 0) == 0; });
    };
    EXPECT_EQ(named(base), 0);
    EXPECT_EQ(named(updated), 3);
    EXPECT_EQ(ofClass(updated, "WRECKS").size(), ofClass(base, "WRECKS").size() + 3);
    EXPECT_EQ(ofClass(updated, "UWTROC").size(), ofClass(base, "UWTROC").size() - 1);
    // The rock that went is the first one; the wreck that changed is the first one that is a point.
    const auto firstPoint = [&](const Chart &chart, const char *objectClass)
    {
        const auto all = ofClass(chart, objectClass);
        return *std::find_if(all.begin(), all.end(),
                             [](const GeoHazard *h) { return !h->shape.lonLat.points.empty(); });
    };
    EXPECT_EQ(firstPoint(updated, "UWTROC")->object->featureId, ofClass(base, "UWTROC")[1]->object->featureId);
    EXPECT_NE(firstPoint(base, "WRECKS")->object->value("VALSOU"), 0.7);
    EXPECT_EQ(firstPoint(updated, "WRECKS")->object->value("VALSOU"), 0.7);
    EXPECT_EQ(firstPoint(updated, "WRECKS")->object->featureId, firstPoint(base, "WRECKS")->object->featureId);
}

struct NoaaCell
{
    const char *name;
    int edition;
    int update;
    int scale;
    std::size_t features;  ///< of the base cell, as its header promises, and of the updates
    std::size_t rocks, wrecks, lands;
};

class Noaa : public testing::TestWithParam<NoaaCell>
{
};

TEST_P(Noaa, isReadWhole)
{
    SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
    const Chart chart = readChart((charts / "noaa" / GetParam().name).string());
    const CellReport &report = chart.cells.at(0);
    EXPECT_EQ(report.name, GetParam().name);
    EXPECT_EQ(report.edition, GetParam().edition);
    EXPECT_EQ(report.update, GetParam().update);
    EXPECT_EQ(report.scale, GetParam().scale);
    EXPECT_EQ(report.soundingDatum, 12);
    EXPECT_EQ(report.verticalDatum, 16);
    EXPECT_EQ(report.groupOne.twiceAreaDifference, "0");
    EXPECT_TRUE(report.groupOne.tiles);
    EXPECT_EQ(report.featuresRead, GetParam().features);
    EXPECT_EQ(report.featuresRead, report.featuresUsed + skippedCount(report));
    EXPECT_EQ(ofClass(chart, "UWTROC").size(), GetParam().rocks);
    EXPECT_EQ(ofClass(chart, "WRECKS").size(), GetParam().wrecks);
    EXPECT_EQ(ofClass(chart, "LNDARE").size(), GetParam().lands);
    for (const GeoHazard &hazard : chart.hazards)
    {
        EXPECT_FALSE(hazard.shape.lonLat.empty());
        EXPECT_NE(hazard.object->rule, HazardRule::Ignored);
        EXPECT_NE(hazard.object->rule, HazardRule::ChartGap);
    }
    for (const GeoHazard *sounding : ofClass(chart, "SOUNDG"))
        ASSERT_TRUE(sounding->object->value("DEPTH").has_value());
}

// Counted with ogrinfo.
INSTANTIATE_TEST_SUITE_P(ChartReader, Noaa,
                         testing::Values(NoaaCell{"US3DE01M", 25, 7, 350000, 2231, 2, 124, 327},
                                         NoaaCell{"US4AK3SB", 1, 1, 40000, 203, 16, 0, 8},
                                         NoaaCell{"US4MD81M", 31, 3, 80000, 7339, 18, 111, 183},
                                         NoaaCell{"US5MA12M", 32, 0, 25000, 2406, 516, 9, 285},
                                         NoaaCell{"US5MD1MC", 4, 0, 12000, 3289, 9, 3, 28}),
                         [](const auto &cell) { return std::string(cell.param.name); });

TEST(ChartReader, keepsSurroundingDepthsOfDangers)
{
    SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
    const Chart chart = readChart((charts / "noaa/US5MA12M").string());
    std::size_t dangers = 0;
    std::size_t known = 0;
    for (const GeoHazard &hazard : chart.hazards)
    {
        const bool isDanger = hazard.object->rule == HazardRule::Danger;
        dangers += isDanger;
        known += isDanger && hazard.object->surroundingDepthM.has_value();
        if (!isDanger)
        {
            EXPECT_FALSE(hazard.object->surroundingDepthM.has_value());
        }
    }
    EXPECT_GT(dangers, 500u);
    EXPECT_GT(known, dangers * 9 / 10);
}

TEST(ChartReader, readsListAttributes)
{
    SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
    const Chart chart = readChart((charts / "noaa/US4MD81M").string());
    const auto areas = ofClass(chart, "RESARE");
    EXPECT_GT(std::count_if(areas.begin(), areas.end(),
                            [](const GeoHazard *h) {
                                return h->object->has("RESTRN", 7) || h->object->has("RESTRN", 8) ||
                                       h->object->has("RESTRN", 14);
                            }),
              0);
    // All of QUASOU are lists; none may have become 0.
    for (const GeoHazard &hazard : chart.hazards)
        EXPECT_FALSE(hazard.object->has("QUASOU", 0));
}

TEST(ChartReader, poolsCellsAndWarnsWhereTheyOverlap)
{
    SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
    const std::string bay = (charts / "noaa/US4MD81M/US4MD81M.000").string();
    const std::string harbour = (charts / "noaa/US5MD1MC/US5MD1MC.000").string();
    const std::string bay2 = (charts / "noaa/US4MD81M").string();
    const Chart pooled = readChart({bay, harbour, bay2});
    ASSERT_EQ(pooled.cells.size(), 2u);
    EXPECT_EQ(pooled.hazards.size(), readChart(bay).hazards.size() + readChart(harbour).hazards.size());
    EXPECT_TRUE(isWarnedOf(pooled.cells[1], "overlaps that of US4MD81M"));
    EXPECT_NEAR(areaOf(pooled.coverage.lonLat), areaOf(readChart(bay).coverage.lonLat), 1e-9);
}

TEST(ChartReader, looksForCellsTwoFoldersDeep)
{
    SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
    const TemporaryFolder folder;
    fs::create_directories(folder / "ENC_ROOT" / "ZZ4SHCHN" / "TOO");
    fs::copy_file(charts / "generated/ZZ4SHCHN.000", folder / "ENC_ROOT" / "ZZ4SHCHN" / "ZZ4SHCHN.000");
    fs::copy_file(charts / "generated/ZZ4SANYA.000", folder / "ENC_ROOT" / "ZZ4SHCHN" / "TOO" / "ZZ4SANYA.000");
    const Chart chart = readChart(folder.path().string());
    ASSERT_EQ(chart.cells.size(), 1u);
    EXPECT_EQ(chart.cells.front().name, "ZZ4SHCHN");
}

TEST(ChartReader, readsTheLargeCellWhole)
{
    SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
    const Chart chart = readChart((charts / "generated/ZZ3NORWY.000").string());
    EXPECT_EQ(chart.cells.at(0).groupOne.twiceAreaDifference, "0");
    EXPECT_EQ(chart.cells.at(0).update, 1);
    EXPECT_EQ(chart.cells.at(0).featuresRead, 6218u);
}

}  // namespace
