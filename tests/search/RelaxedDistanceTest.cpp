#include <seahex/search/RelaxedDistance.h>

#include <seahex/geometry/HexNorm.h>
#include <seahex/geometry/HexTraversal.h>

#include "support/AsciiWorld.h"
#include "support/ExplicitGraph.h"
#include "support/HexOracle.h"
#include "support/Random.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

/// What a path is made of: jumps of so many rings, at their length or at D; D is the relaxed distance of one ring.
struct Jumping
{
    int rings;
    LengthMetric metric;

    int relaxedRings() const { return metric == LengthMetric::Lattice ? 1 : rings; }
    double cost(HexCoord offset) const
    {
        const auto q = static_cast<double>(offset.q);
        const auto s = static_cast<double>(offset.s);
        return metric == LengthMetric::Lattice ? static_cast<double>(hexNorm(offset))
                                               : std::sqrt(q * q + q * s + s * s);
    }
};

constexpr std::array<Jumping, 5> allKinds = {{{1, LengthMetric::Euclidean},
                                              {2, LengthMetric::Euclidean},
                                              {3, LengthMetric::Euclidean},
                                              {2, LengthMetric::Lattice},
                                              {3, LengthMetric::Lattice}}};

/// A far cell in one of the three directions, so that lines of each kind are tried.
HexCoord farFrom(HexCoord goal, int direction)
{
    constexpr std::array<HexCoord, 6> far = {{{-10, 20}, {20, -10}, {-10, -10}, {10, -20}, {-20, 10}, {10, 10}}};
    return goal + far[static_cast<std::size_t>(direction)];
}

/// Checks h = 0 at the goal and h(u) <= c(u, v) + h(v) for every valid jump from u to v. @return cells that may jump
std::vector<HexCoord> checkConsistency(const std::shared_ptr<const HexOccupancy> &occupancy, HexCoord start,
                                       HexCoord goal, const Jumping &kind)
{
    RelaxedDistance distance(occupancy, start, goal, kind.relaxedRings());
    EXPECT_EQ(distance(goal), 0.0);
    std::vector<HexCoord> cells;
    forEachCell(occupancy->lattice(), 0,
                [&](HexCoord from)
                {
                    if (occupancy->isBlocked(from))
                        return;
                    cells.push_back(from);
                    for (const RingOffset &jump : ringOffsets(kind.rings))
                    {
                        const HexCoord to = from + jump.offset;
                        if (forEachTouchedCell(from, to, [&](HexCoord cell) { return occupancy->isFree(cell); }))
                        {
                            EXPECT_LE(distance(from), kind.cost(jump.offset) + distance(to) + 1e-12)
                                << toPicture(*occupancy, {from, to, goal});
                        }
                    }
                });
    return cells;
}

/// The relaxed world written out edge by edge from the positions of centres, the cells around the rectangle included.
class RelaxedWorld
{
public:
    RelaxedWorld(const HexOccupancy &occupancy, const HexLines &lines, int rings)
        : occupancy_(occupancy), lines_(lines), frame_(Point::Zero(), 1.0, occupancy.lattice().columns() + 2 * margin,
                                                       occupancy.lattice().rows() + 2 * margin),
          backwards_(static_cast<std::size_t>(frame_.cellCount()))
    {
        forEachCell(occupancy.lattice(), margin,
                    [&](HexCoord from)
                    {
                        for (std::int64_t q = -3; q <= 3; ++q)
                            for (std::int64_t s = -3; s <= 3; ++s)
                                addMove(from, from + HexCoord{q, s}, rings);
                    });
        costs_ = backwards_.costsFrom({{vertex(lines.origin()), 0.0}});
    }

    double operator()(HexCoord cell) const { return costs_[vertex(cell)]; }

private:
    static constexpr std::int64_t margin = 4;  // an even number, so that rows keep their parity

    std::size_t vertex(HexCoord cell) const
    {
        const OffsetCoord o = toOffset(cell);
        return vertexOf(frame_, toCube({o.column + margin, o.row + margin}));
    }

    bool counts(HexCoord cell) const { return occupancy_.isFree(cell) || lines_.placeOf(cell).line == 0; }

    void addMove(HexCoord from, HexCoord to, int rings)
    {
        const OffsetCoord o = toOffset(to);
        if (!frame_.contains(toCube({o.column + margin, o.row + margin})))
            return;
        const std::int64_t fromLine = lines_.placeOf(from).line;
        const std::int64_t toLine = lines_.placeOf(to).line;
        const std::int64_t lines = std::abs(fromLine) - std::abs(toLine);
        if (fromLine * toLine < 0 || lines < 0)
            return;
        const double length = (frame_.centre(to) - frame_.centre(from)).norm();
        const double aside = std::sqrt(std::max(0.0, length * length - 0.75 * static_cast<double>(lines * lines)));
        const auto is = [aside](double value)
        {
            return std::abs(aside - value) < 1e-6;
        };
        bool free = counts(to);
        if (lines > 1)
            forEachCell(occupancy_.lattice(), margin,
                        [&](HexCoord cell) {
                            free =
                                free && (cell == from || counts(cell) || !touchesExactly<std::int64_t>(from, to, cell));
                        });
        double cost = infinity;
        if (lines == 0 && is(1.0))
            cost = 1.0;
        else if (lines == 1 && is(0.5) && free)
            cost = 1.0;
        else if (lines == 1 && is(1.5) && free && rings > 1)
            cost = rings == 2 ? std::sqrt(3.0) : std::sqrt(7.0) - 1.0;
        else if (lines == 2 && is(0.0) && free && rings > 1)
            cost = std::sqrt(3.0);
        else if (lines == 3 && is(0.5) && free && rings > 2)
            cost = std::sqrt(7.0);
        if (cost < infinity)
            backwards_.addEdge(vertex(to), vertex(from), cost);
    }

    const HexOccupancy &occupancy_;
    HexLines lines_;
    HexLattice frame_;
    ExplicitGraph backwards_;
    std::vector<double> costs_;
};

}  // namespace

TEST(RelaxedDistance, noJumpOfAnySmallWorldGainsMoreThanItCosts)
{
    // every occupancy of 4 x 3 cells with every goal, lines in each direction
    const HexLattice lattice(Point::Zero(), 1.0, 3, 4);
    for (unsigned int mask = 0; mask < 1u << 12; ++mask)
    {
        std::vector<HexCoord> blocked;
        for (unsigned int i = 0; i < 12; ++i)
            if ((mask >> i) & 1)
                blocked.push_back(toCube({i % 3, i / 3}));
        const auto occupancy = occupancyWith(lattice, blocked);
        for (unsigned int i = mask % 5; i < 12; i += 5)  // some of the goals
            if (!((mask >> i) & 1))
                for (int direction = 0; direction < 3; ++direction)
                {
                    const HexCoord goal = toCube({i % 3, i / 3});
                    checkConsistency(occupancy, farFrom(goal, direction), goal, {3, LengthMetric::Euclidean});
                    ASSERT_FALSE(HasFailure()) << "direction " << direction;
                }
    }
}

TEST(RelaxedDistance, isConsistentAdmissibleAndOftenExact)
{
    std::uint64_t cells = 0;
    std::uint64_t aboveNorm = 0;
    std::uint64_t exact = 0;
    std::uint64_t cutOff = 0;
    forEachSeed(1500,
                [&](Random &random)
                {
                    const HexLattice lattice(Point(3.0, -2.0), 0.7, random.integer(1, 14), random.integer(1, 14));
                    const auto occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.6));
                    const HexCoord goal = random.cellOf(lattice);
                    if (occupancy->isBlocked(goal))
                        return;
                    const Jumping kind = allKinds[static_cast<std::size_t>(random.integer(0, 4))];
                    const HexCoord start = farFrom(goal, static_cast<int>(random.integer(0, 5)));
                    RelaxedDistance distance(occupancy, start, goal, kind.relaxedRings());
                    const std::vector<double> truth =
                        jumpGraph(*occupancy, kind.rings, kind.metric).costsFrom({{vertexOf(lattice, goal), 0.0}});
                    for (const HexCoord cell : checkConsistency(occupancy, start, goal, kind))
                    {
                        const double h = distance(cell);
                        const double remains = truth[vertexOf(lattice, cell)];
                        ASSERT_LE(h, remains + 1e-12) << toPicture(*occupancy, {cell, goal});
                        ++cells;
                        aboveNorm += h > ringNorm(goal - cell, kind.relaxedRings()) + 1e-9 ? 1 : 0;
                        exact += h > remains - 1e-9 ? 1 : 0;
                        cutOff += std::isinf(h) ? 1 : 0;
                    }
                    ASSERT_FALSE(testing::Test::HasFailure());
                });
    EXPECT_GT(aboveNorm, cells / 6) << "of so many cells: " << cells;
    EXPECT_GT(exact, cells / 4);
    EXPECT_GT(cutOff, 200u);
}

TEST(RelaxedDistance, isTheDistanceOfTheRelaxedWorld)
{
    forEachSeed(400,
                [](Random &random)
                {
                    const HexLattice lattice(Point::Zero(), 1.0, random.integer(1, 7), random.integer(1, 7));
                    const auto occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.7));
                    const HexCoord goal = random.cellOf(lattice);
                    if (occupancy->isBlocked(goal))
                        return;
                    const HexCoord start = farFrom(goal, static_cast<int>(random.integer(0, 5)));
                    const auto rings = static_cast<int>(random.integer(1, 3));
                    RelaxedDistance distance(occupancy, start, goal, rings);
                    const RelaxedWorld world(*occupancy, HexLines::across(start, goal), rings);
                    forEachCell(lattice, 0,
                                [&](HexCoord cell)
                                {
                                    if (occupancy->isBlocked(cell))
                                        return;
                                    if (std::isinf(world(cell)))
                                        EXPECT_EQ(distance(cell), infinity);
                                    else
                                        EXPECT_NEAR(distance(cell), world(cell), 1e-9) << rings << " rings";
                                });
                    ASSERT_FALSE(testing::Test::HasFailure()) << toPicture(*occupancy, {goal});
                });
}

TEST(RelaxedDistance, knowsTheWayOutOfABay)
{
    const AsciiWorld world(R"(
         . . . . B . . . .
        . . . . . . . . .
         . . # # # # # . .
        . . # . . . # . .
         . . # . . . # . .
        . . # . A . # . .
         . . . . . . . . .
    )");
    // Straight on it would be 5 steps, and the bay's end alone makes it 6; its sides are passed along a line.
    RelaxedDistance distance(world.shared(), world.cell('A'), world.cell('B'), 1);
    EXPECT_EQ(hexDistance(world.cell('A'), world.cell('B')), 5);
    EXPECT_EQ(distance(world.cell('A')), 8.0);
}

TEST(RelaxedDistance, linesArePassedOneByOneAsFarAsTheStart)
{
    const AsciiWorld world(R"(
         B . . .
        . # . .
         . . . .
        . A . .
         . . . .
    )");
    for (const auto &[start, goal] : {std::pair('A', 'B'), std::pair('B', 'A')})
    {
        RelaxedDistance distance(world.shared(), world.cell(start), world.cell(goal), 3);
        for (int line = 0; line < 3; ++line)
            EXPECT_TRUE(distance.passNextLine());
        EXPECT_FALSE(distance.passNextLine());
        RelaxedDistance lazy(world.shared(), world.cell(start), world.cell(goal), 3);
        forEachCell(world.lattice(), 0,
                    [&](HexCoord cell)
                    {
                        if (world.occupancy().isFree(cell))
                        {
                            EXPECT_EQ(distance(cell), lazy(cell));
                        }
                    });
    }
}
