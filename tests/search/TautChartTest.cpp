#include "support/Random.h"

#include <seahex/chart/ChartArena.h>
#include <seahex/chart/ChartReader.h>
#include <seahex/route/RouteSmoother.h>
#include <seahex/search/AStar.h>
#include <seahex/search/JumpGraph.h>
#include <seahex/search/LengthWeight.h>
#include <seahex/search/TautSearch.h>
#include <seahex/world/SegmentValidity.h>

#include <gtest/gtest.h>

namespace seahex::test
{
namespace
{

bool never()
{
    return false;
}

/// The best path on the lattice with three rings, pulled taut; empty if there is none.
Route pulledRoute(const HexOccupancy &occupancy, const HexJumps &jumps, HexCoord start, HexCoord goal)
{
    const HexLattice &lattice = occupancy.lattice();
    JumpGraph<LengthWeight> graph(occupancy, jumps, {{goal, 0.0}},
                                  LengthWeight(lattice, jumps, LengthMetric::Euclidean, Guidance::Distance,
                                               lattice.centre(start), lattice.centre(goal)));
    AStar<JumpGraph<LengthWeight>> search(graph);
    search.addStart(occupancy.layout().index(start), 0.0);
    if (search.run(never, 1000) != SearchStatus::Found)
        return Route();
    std::vector<Point> points;
    for (const CellIndex cell : search.path())
        points.push_back(lattice.centre(occupancy.layout().cell(cell)));
    return pullString(Route(points), occupancy);
}

TEST(TautSearchOnAChart, IsNeverLongerThanAPulledPathOfTheLattice)
{
    ArenaOptions options;
    options.scope = HazardScope::LandOnly;
    options.pitch = 450.0;
    const ChartArena arena(readChart(SEAHEX_MAPS_DIR "/shangchuan.000"), options);
    const HexOccupancy &occupancy = *arena.occupancy();
    const HexLattice &lattice = occupancy.lattice();
    const HexJumps jumps(occupancy.layout(), 3, JumpSet::Primitive);
    TautSearch search(occupancy);
    Random random(1);
    SCOPED_TRACE(random.seedText());
    const auto freeCell = [&]
    {
        while (true)
        {
            const HexCoord cell = random.cellOf(lattice);
            if (occupancy.isFree(cell))
                return cell;
        }
    };
    int found = 0;
    for (int i = 0; i < 100; ++i)
    {
        const HexCoord start = freeCell();
        const HexCoord goal = freeCell();
        SCOPED_TRACE(::testing::Message() << "query " << i);
        const Route pulled = pulledRoute(occupancy, jumps, start, goal);
        search.begin(lattice.centre(start), lattice.centre(goal));
        ASSERT_EQ(search.run(never, 1000), pulled.empty() ? SearchStatus::Exhausted : SearchStatus::Found);
        if (pulled.empty())
            continue;
        ++found;
        EXPECT_LE(search.length(), pulled.length() * (1.0 + 1e-12));
        EXPECT_GE(search.length(), 0.97 * pulled.length());
        const Route route = search.route();
        ASSERT_FALSE(route.empty());
        for (std::size_t leg = 0; leg < route.legCount(); ++leg)
            EXPECT_TRUE(isFree(occupancy, route.leg(leg).from, route.leg(leg).to));
        EXPECT_LE(route.length(), search.length() * (1.0 + 1e-7) + 1e-3);
    }
    EXPECT_GT(found, 50);
}

}  // namespace
}  // namespace seahex::test
