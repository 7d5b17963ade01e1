// AStar and JumpGraph on squares.

#include "support/SquareSearch.h"
#include "support/AsciiWorld.h"
#include "support/ExplicitGraph.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// What is wrong with a path; empty if it leads from cell to cell by valid steps and costs what is said.
std::string judge(const SquareOccupancy &occupancy, const std::vector<OffsetCoord> &path, OffsetCoord from,
                  OffsetCoord to, int neighbours, JumpRule rule, double cost)
{
    if (path.empty() || path.front() != from || path.back() != to)
        return "does not lead from start to goal";
    double sum = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i)
    {
        const std::int64_t columns = std::abs(path[i].column - path[i - 1].column);
        const std::int64_t rows = std::abs(path[i].row - path[i - 1].row);
        if (std::max(columns, rows) != 1 || (neighbours == 4 && columns + rows != 1))
            return "a step that is none";
        const OffsetCoord beside[2] = {{path[i - 1].column, path[i].row}, {path[i].column, path[i - 1].row}};
        if (occupancy.isBlocked(path[i]))
            return "a step into a blocked cell";
        if (rule == JumpRule::Safe && (occupancy.isBlocked(beside[0]) || occupancy.isBlocked(beside[1])))
            return "a corner is cut";
        sum += columns + rows == 2 ? std::sqrt(2.0) : 1.0;
    }
    return std::abs(sum - cost) < 1e-9 ? "" : "the path's steps cost " + std::to_string(sum);
}

}  // namespace

TEST(SquareSearch, costsEqualDijkstrasForEveryMethod)
{
    int reached = 0;
    int unreachable = 0;
    for (std::uint64_t seed = 1; seed <= 1500; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const SquareLattice lattice(Point(5.0, 7.0), 2.0, random.integer(1, 12), random.integer(1, 12));
        const auto occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.5));
        const OffsetCoord from = random.cellOf(lattice);
        const OffsetCoord to = random.cellOf(lattice);
        if (occupancy->isBlocked(from) || occupancy->isBlocked(to))
            continue;
        for (const int neighbours : {4, 8})
            for (const JumpRule rule : {JumpRule::Safe, JumpRule::Hopping})
            {
                const double expected = stepGraph(*occupancy, neighbours, rule)
                                            .cheapest({{vertexOf(lattice, from), 0.0}}, {{vertexOf(lattice, to), 0.0}});
                (std::isinf(expected) ? unreachable : reached) += 1;
                for (const Guidance guidance : {Guidance::None, Guidance::Distance, Guidance::Euclidean,
                                                Guidance::Cheng, Guidance::Wang, Guidance::TieBreak, Guidance::Relaxed})
                {
                    SCOPED_TRACE(std::to_string(neighbours) + " neighbours, " + toString(rule) + ", " +
                                 toString(guidance));
                    SquareSearch search(*occupancy, neighbours, rule, guidance, from, to);
                    const double cost = search.cost(from, to);
                    if (std::isinf(expected))
                    {
                        ASSERT_EQ(cost, expected);
                        ASSERT_TRUE(search.path().empty());
                        continue;
                    }
                    ASSERT_NEAR(cost, expected, 1e-9) << toPicture(*occupancy, search.path());
                    ASSERT_EQ(judge(*occupancy, search.path(), from, to, neighbours, rule, cost), "")
                        << toPicture(*occupancy, search.path());
                }
            }
    }
    EXPECT_GE(reached, 1000) << "so many at least";
    EXPECT_GE(unreachable, 100);
}

TEST(SquareSearch, cornersAreCutOnlyWhereThatIsAllowed)
{
    // . #
    // . .   from the north-west to the south-east
    const SquareLattice lattice(Point::Zero(), 1.0, 2, 2);
    const auto occupancy = occupancyWith(lattice, {{1, 0}});
    const auto costBy = [&](int neighbours, JumpRule rule)
    {
        return SquareSearch(*occupancy, neighbours, rule, Guidance::Distance).cost({0, 0}, {1, 1});
    };
    EXPECT_EQ(costBy(8, JumpRule::Safe), 2.0);
    EXPECT_EQ(costBy(8, JumpRule::Hopping), std::sqrt(2.0));
    EXPECT_EQ(costBy(4, JumpRule::Safe), 2.0);
    EXPECT_EQ(costBy(4, JumpRule::Hopping), 2.0);
}
