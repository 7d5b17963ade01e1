#include "seahex/chart/ChartArena.h"

#include "support/Random.h"
#include "support/SquareOracle.h"
#include "support/TestCharts.h"

#include <seahex/chart/ChartReader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace seahex
{
namespace
{

using test::boxWkt;

/// Deep water of a tenth of a degree with an island, a shoal, a rock of unknown depth and a deep wreck.
Chart smallChart()
{
    test::TemporaryFolder folder;
    const auto path = folder / "small.gpkg";
    test::writeChart(path,
                     {{"M_COVR", {{boxWkt(10.0, 50.0, 10.1, 50.1), {{"CATCOV", 1}}}}},
                      {"DEPARE",
                       {{"POLYGON ((10 50,10.1 50,10.1 50.1,10 50.1,10 50),(10.02 50.02,10.02 50.03,10.03 50.03,10.03 "
                         "50.02,10.02 50.02),(10.06 50.06,10.06 50.07,10.07 50.07,10.07 50.06,10.06 50.06))",
                         {{"DRVAL1", 10.0}, {"DRVAL2", 20.0}}},
                        {boxWkt(10.06, 50.06, 10.07, 50.07), {{"DRVAL1", 1.0}, {"DRVAL2", 2.0}}}}},
                      {"LNDARE", {{boxWkt(10.02, 50.02, 10.03, 50.03), {}}}},
                      {"UWTROC", {{"POINT (10.05 50.04)", {{"WATLEV", 3}}}}},
                      {"WRECKS", {{"POINT (10.08 50.02)", {{"VALSOU", 9.0}, {"WATLEV", 3}}}}}});
    return readChart(path.string());
}

const Chart &chart()
{
    static const Chart small = smallChart();
    return small;
}

ChartArena arenaWith(double marginM, double pitch = 50.0)
{
    ArenaOptions options;
    options.vessel.marginM = marginM;
    options.pitch = pitch;
    return ChartArena(chart(), options);
}

bool isFreeAt(const ChartArena &arena, double latitude, double longitude)
{
    const Point p = arena.projection().forward(GeoPoint::fromLatLon(latitude, longitude));
    return arena.occupancy()->isFree(arena.occupancy()->lattice().cellAt(p));
}

TEST(ChartArena, blocksWhatBlocksAndNothingElse)
{
    const ChartArena arena = arenaWith(0.0);
    EXPECT_FALSE(isFreeAt(arena, 50.025, 10.025)) << "island";
    EXPECT_FALSE(isFreeAt(arena, 50.065, 10.065)) << "shoal";
    EXPECT_FALSE(isFreeAt(arena, 50.04, 10.05)) << "rock";
    EXPECT_TRUE(isFreeAt(arena, 50.02, 10.08)) << "deep wreck";
    EXPECT_TRUE(isFreeAt(arena, 50.05, 10.02)) << "open water";
    EXPECT_FALSE(isFreeAt(arena, 50.05, 9.9999)) << "outside";
}

TEST(ChartArena, keepsTheMarginInMetres)
{
    // the island's north side is at 50.03; 200 m are 0.0018 degree
    EXPECT_TRUE(isFreeAt(arenaWith(0.0, 20.0), 50.0318 - 0.0005, 10.025));
    EXPECT_FALSE(isFreeAt(arenaWith(200.0, 20.0), 50.0318 - 0.0005, 10.025));
    EXPECT_TRUE(isFreeAt(arenaWith(200.0, 20.0), 50.0318 + 0.0005, 10.025));
    EXPECT_FALSE(isFreeAt(arenaWith(200.0, 20.0), 50.0015, 10.05)) << "the edge of the coverage has a margin too";
}

TEST(ChartArena, explainsEveryBlockedCellAndNoFreeOne)
{
    const ChartArena arena = arenaWith(0.0, 100.0);
    const HexLattice &lattice = arena.occupancy()->lattice();
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < lattice.columns(); ++column)
        {
            const HexCoord cell = toCube({column, row});
            EXPECT_EQ(arena.explainCell(cell).empty(), arena.occupancy()->isFree(cell))
                << "column " << column << ", row " << row;
        }
}

TEST(ChartArena, namesTheObject)
{
    const ChartArena arena = arenaWith(0.0);
    const Point rock = arena.projection().forward(GeoPoint::fromLatLon(50.04, 10.05));
    const std::vector<std::string> reasons = arena.explainPoint(rock);
    ASSERT_EQ(reasons.size(), 1u);
    EXPECT_NE(reasons.front().find("UWTROC"), std::string::npos) << reasons.front();
    EXPECT_TRUE(arena.explainPoint(rock + Point(12.0, 0.0)).empty()) << "10 m around a rock";
    EXPECT_FALSE(arena.explainPoint(rock + Point(9.0, 0.0)).empty());
    EXPECT_FALSE(arena.explainPoint(arena.projection().forward(GeoPoint::fromLatLon(49.9, 10.05))).empty());
}

TEST(ChartArena, knowsLandOnlyWhereToldSo)
{
    ArenaOptions options;
    options.scope = HazardScope::LandOnly;
    options.pitch = 50.0;
    const ChartArena arena(chart(), options);
    EXPECT_FALSE(isFreeAt(arena, 50.025, 10.025)) << "island";
    EXPECT_TRUE(isFreeAt(arena, 50.065, 10.065)) << "shoal";
    EXPECT_TRUE(isFreeAt(arena, 50.04, 10.05)) << "rock";
}

TEST(ChartArena, takesLandOnlyAndNoMarginInDegrees)
{
    ArenaOptions options;
    options.scope = HazardScope::LandOnly;
    options.projection = Projection::plateCarree();
    options.pitch = 0.001;
    EXPECT_FALSE(isFreeAt(ChartArena(chart(), options), 50.025, 10.025));
    options.vessel.marginM = 10.0;
    EXPECT_THROW(ChartArena(chart(), options), std::domain_error);
    options.vessel.marginM = 0.0;
    options.scope = HazardScope::All;
    EXPECT_THROW(ChartArena(chart(), options), std::domain_error);
}

TEST(ChartArena, refusesAPitchThatIsNone)
{
    ArenaOptions options;
    options.pitch = -5.0;
    EXPECT_THROW(ChartArena(chart(), options), std::domain_error);
}

TEST(ChartArena, choosesThePitch)
{
    EXPECT_EQ(automaticPitchM({Point(0, 0), Point(1000, 1000)}), 20.0);
    const double pitch = automaticPitchM({Point(0, 0), Point(2e5, 3e5)});
    const HexLattice lattice = HexLattice::covering({Point(0, 0), Point(2e5, 3e5)}, pitch);
    EXPECT_NEAR(static_cast<double>(lattice.cellCount()), 4e6, 2e4);
}

TEST(ChartArena, isWhatBuildOccupancyGives)
{
    const auto occupancy = buildOccupancy(chart(), Vessel(), 50.0);
    EXPECT_EQ(occupancy->words(), arenaWith(0.0).occupancy()->words());
}

/// Is the cell within a hazard's radius, outside the coverage or too near to its edge? Cell by cell in long double;
/// empty where that is closer than rounding.
std::optional<bool> mustBeBlocked(const ChartArena &arena, const test::SquareOracle &oracle, OffsetCoord cell)
{
    constexpr long double rounding = 1e-4L;
    bool isBlocked = false;
    bool isClose = false;
    const auto keepOut = [&](long double distance, double radiusM)
    {
        const long double gap = distance - arena.scale() * (radiusM + ChartArena::growthM);
        isBlocked = isBlocked || gap < -rounding;
        isClose = isClose || std::abs(gap) <= rounding;
    };
    bool isCovered = false;
    for (const Polygon &area : arena.coverage().areas)
    {
        isCovered = isCovered || oracle.isCentreInside(area, cell);
        keepOut(oracle.distanceToRings(area, cell), arena.vessel().marginM);
    }
    for (std::size_t i = 0; i < arena.hazards().size(); ++i)
        if (arena.verdicts()[i].blocks())
            keepOut(oracle.distance(arena.hazards()[i].shape, cell),
                    keepOutRadiusM(*arena.hazards()[i].object, arena.vessel()));
    if (isBlocked || !isCovered)
        return true;
    return isClose ? std::nullopt : std::optional<bool>(false);
}

TEST(ChartArena, fillsSquaresOfTheSameWater)
{
    for (const double margin : {0.0, 150.0})
    {
        const ChartArena arena = arenaWith(margin, 100.0);
        const HexLattice &hexagons = arena.occupancy()->lattice();
        EXPECT_EQ(arena.fill(hexagons)->words(), arena.occupancy()->words());

        const auto lattice = SquareLattice::covering(hexagons.bounds(), hexagons.pitch());
        const auto squares = arena.fill(lattice);
        const test::SquareOracle oracle(lattice);
        std::int64_t judged = 0;
        test::forEachCell(lattice, 0,
                          [&](OffsetCoord cell)
                          {
                              const std::optional<bool> expected = mustBeBlocked(arena, oracle, cell);
                              judged += expected ? 1 : 0;
                              ASSERT_EQ(squares->isBlocked(cell), expected.value_or(squares->isBlocked(cell)))
                                  << "column " << cell.column << ", row " << cell.row << ", margin " << margin;
                          });
        EXPECT_GT(judged, lattice.cellCount() - 10);
        EXPECT_GT(squares->blockedCount(), 100);
        EXPECT_LT(squares->blockedCount(), lattice.cellCount() / 2);
    }
}

}  // namespace
}  // namespace seahex
