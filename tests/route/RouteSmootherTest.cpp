#include "seahex/route/RouteSmoother.h"

#include "support/AsciiWorld.h"
#include "support/Random.h"

#include <seahex/geometry/Shape.h>
#include <seahex/search/AStar.h>
#include <seahex/search/JumpGraph.h>
#include <seahex/search/LengthWeight.h>
#include <seahex/world/SegmentValidity.h>

#include <gtest/gtest.h>

#include <boost/geometry.hpp>

#include <cmath>
#include <memory>
#include <vector>

namespace seahex
{
namespace
{

using test::AsciiWorld;
using test::Random;

/// A lattice path between two cells by A*; empty if there is none.
Route latticePath(const HexOccupancy &occupancy, HexCoord from, HexCoord to, int rings)
{
    const HexJumps jumps(occupancy.layout(), rings, JumpSet::Primitive);
    const HexLattice &lattice = occupancy.lattice();
    JumpGraph<LengthWeight> graph(occupancy, jumps, {{to, 0.0}},
                                  LengthWeight(lattice, jumps, LengthMetric::Euclidean, Guidance::Distance,
                                               lattice.centre(from), lattice.centre(to)));
    AStar<JumpGraph<LengthWeight>> search(graph);
    search.addStart(occupancy.layout().index(from), 0.0);
    search.run([] { return false; }, 1000);
    std::vector<Point> centres;
    for (const CellIndex cell : search.path())
        centres.push_back(lattice.centre(occupancy.layout().cell(cell)));
    return Route(centres);
}

/// No leg touches a blocked cell: by polygons of corners, not by the traversal that the smoother uses. A hair's breadth
/// of the traversal's own tolerance is on the safe side.
testing::AssertionResult keepsClear(const Route &route, const HexOccupancy &occupancy)
{
    using Segment = boost::geometry::model::segment<Point>;
    const HexLattice &lattice = occupancy.lattice();
    for (std::int64_t row = -1; row <= lattice.rows(); ++row)
        for (std::int64_t column = -1; column <= lattice.columns(); ++column)
        {
            const HexCoord cell = toCube({column, row});
            if (occupancy.isFree(cell))
                continue;
            Polygon hexagon;
            for (const Point &corner : lattice.corners(cell))
                hexagon.outer().push_back(corner);
            hexagon.outer().push_back(hexagon.outer().front());
            for (std::size_t i = 0; i < route.legCount(); ++i)
                if (boost::geometry::intersects(Segment(route.leg(i).from, route.leg(i).to), hexagon))
                    return testing::AssertionFailure()
                           << "leg " << i << " touches the blocked cell in column " << column << ", row " << row;
        }
    return testing::AssertionSuccess();
}

TEST(RouteSmoother, straightensWhatIsFree)
{
    const AsciiWorld world(R"(
         A . . . . .
        . . . . . .
         . . . . . .
        . . . . . B
    )");
    const Route path = latticePath(world.occupancy(), world.cell('A'), world.cell('B'), 1);
    ASSERT_GT(path.legCount(), 2u);
    const Route pulled = pullString(path, world.occupancy());
    ASSERT_EQ(pulled.legCount(), 1u);
    EXPECT_EQ(pulled.waypoints().front(), world.centre('A'));
    EXPECT_EQ(pulled.waypoints().back(), world.centre('B'));
}

TEST(RouteSmoother, pullsTautAroundACorner)
{
    const AsciiWorld world(R"(
         . . . . . . . . .
        . . . . . . . . .
         . . . . # . . . .
        . . . . # # . . .
         A . . . # . . . B
        . . . . # # . . .
         . . . . # . . . .
        . . . . # # . . .
    )");
    const Route pulled =
        pullString(latticePath(world.occupancy(), world.cell('A'), world.cell('B'), 1), world.occupancy());
    EXPECT_TRUE(keepsClear(pulled, world.occupancy()));
    // The taut string runs over the tip of the wall's topmost cell, from which it keeps the traversal's tolerance.
    const HexLattice &lattice = world.lattice();
    const Point tip = lattice.corners(toCube({4, 2}))[0];
    const double leftShoulder = (lattice.corners(toCube({4, 2}))[1] - world.centre('A')).norm();
    const double taut = std::max((tip - world.centre('A')).norm(), leftShoulder) + (tip - world.centre('B')).norm();
    EXPECT_GE(pulled.length(), taut - 0.2);
    EXPECT_LE(pulled.length(), taut + 0.1);
}

TEST(RouteSmoother, keepsShortRoutes)
{
    const AsciiWorld world(R"(
         A . B
        . . .
    )");
    EXPECT_TRUE(pullString(Route(), world.occupancy()).empty());
    EXPECT_EQ(pullString(Route({world.centre('A')}), world.occupancy()).waypoints().size(), 1u);
    EXPECT_EQ(pullString(Route({world.centre('A'), world.centre('B')}), world.occupancy()).legCount(), 1u);
}

TEST(RouteSmoother, neverTouchesABlockedCellAndNeverGetsLonger)
{
    int routes = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice(random.pointIn({Point(-1e4, -1e4), Point(1e4, 1e4)}), random.real(0.5, 60.0),
                                 random.integer(5, 30), random.integer(5, 30));
        const auto occupancy = randomOccupancy(random, lattice, random.real(0.05, 0.35));
        const HexCoord from = random.cellOf(lattice);
        const HexCoord to = random.cellOf(lattice);
        if (occupancy->isBlocked(from) || occupancy->isBlocked(to))
            continue;
        const Route path = latticePath(*occupancy, from, to, static_cast<int>(random.integer(1, 3)));
        if (path.legCount() < 2)
            continue;
        ++routes;
        const Route pulled = pullString(path, *occupancy);
        EXPECT_EQ(pulled.waypoints().front(), path.waypoints().front());
        EXPECT_EQ(pulled.waypoints().back(), path.waypoints().back());
        EXPECT_LE(pulled.length(), path.length() * (1.0 + 1e-12));
        EXPECT_TRUE(keepsClear(pulled, *occupancy)) << test::toPicture(*occupancy);
    }
    EXPECT_GT(routes, 100);
}

TEST(RouteSmoother, takesAnyPredicate)
{
    // a disc of radius 1 in the way, as a predicate that knows no cells
    const auto clear = [](const Point &a, const Point &b)
    {
        const Point d = b - a;
        const double t = d.squaredNorm() > 0.0 ? std::clamp(-a.dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
        return (a + t * d).norm() > 1.0;
    };
    const Route route({Point(-3, 0), Point(-3, 3), Point(3, 3), Point(3, 0)});
    const Route pulled = pullString(route, clear, 0.01);
    for (std::size_t i = 0; i < pulled.legCount(); ++i)
        EXPECT_TRUE(clear(pulled.leg(i).from, pulled.leg(i).to));
    // tangents from (-3, 0) and (3, 0) and the arc between their points of contact
    const double half = std::acos(1.0 / 3.0);
    const double taut = 2.0 * std::sqrt(8.0) + (2.0 * std::acos(0.0) - 2.0 * half);
    EXPECT_GE(pulled.length(), taut);
    EXPECT_LE(pulled.length(), 1.05 * taut);
}

}  // namespace
}  // namespace seahex
