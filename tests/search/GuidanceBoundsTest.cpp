// The bounds of each guidance against the true cost to the goal, cell by cell.

#include <seahex/search/SafetyLengthWeight.h>

#include "support/JumpKinds.h"

#include "support/AsciiWorld.h"

#include <algorithm>
#include <cmath>

using namespace seahex;
using namespace seahex::test;

namespace
{

constexpr double finish = 0.25;

template <class Kind>
class GuidanceBounds : public ::testing::Test
{
public:
    /// Least cost from each cell to the goal. The edges are written the other way round, for costs that depend on the
    /// direction.
    static std::vector<double> costsToGoal(const RandomWorld<Kind> &world, int reach, const CostOfJump &cost)
    {
        return Kind::graph(*world.occupancy, reach, JumpRule::Safe,
                           [&cost](OffsetCoord from, OffsetCoord to) { return cost(to, from); })
            .costsFrom({{vertexOf(world.lattice, world.goal), finish}});
    }

    static std::vector<OffsetCoord> freeCells(const RandomWorld<Kind> &world)
    {
        std::vector<OffsetCoord> cells;
        for (std::int64_t row = 0; row < world.lattice.rows(); ++row)
            for (std::int64_t column = 0; column < world.lattice.columns(); ++column)
                if (world.occupancy->isFree(Kind::KnownLattice::cell({column, row})))
                    cells.push_back({column, row});
        return cells;
    }

    /// @return by how much the bound exceeds the least cost where it does so most
    template <class Weight>
    static double worstExcess(const RandomWorld<Kind> &world, const Weight &weight, const std::vector<double> &least)
    {
        double excess = -1e300;
        for (const OffsetCoord cell : freeCells(world))
            excess = std::max(excess, weight.bound(cell, {world.goal, finish}) - least[vertexOf(world.lattice, cell)]);
        return excess;
    }

    /// @return by how much the bound falls more over a jump than that costs, where it does so most
    template <class Weight>
    static double worstFall(const RandomWorld<Kind> &world, const Jumps &jumps, const Weight &weight)
    {
        double fall = -1e300;
        const CellLayout &layout = world.occupancy->layout();
        for (const OffsetCoord cell : freeCells(world))
            for (std::size_t k = 0; k < jumps.size(); ++k)
            {
                const CellIndex from = layout.index(cell);
                const CellIndex to = jumps.successor(from, k);
                const OffsetCoord next = layout.offset(to);
                if (world.lattice.contains(Kind::KnownLattice::cell(next)))
                    fall = std::max(fall, weight.bound(cell, {world.goal, finish}) -
                                              weight.bound(next, {world.goal, finish}) -
                                              weight.jumpCost(from, to, k, 255));
            }
        return fall;
    }
};

TYPED_TEST_SUITE(GuidanceBounds, JumpKinds, JumpKindNames);

constexpr Guidance everyGuidance[] = {Guidance::None, Guidance::Distance, Guidance::Euclidean, Guidance::Cheng,
                                      Guidance::Wang, Guidance::TieBreak, Guidance::Relaxed};

bool isConsistent(Guidance guidance)
{
    return guidance != Guidance::Cheng;
}

}  // namespace

TYPED_TEST(GuidanceBounds, areAdmissibleAndButChengsConsistent)
{
    using Norm = typename TypeParam::Norm;
    int overestimated = 0;
    forEachSeed(
        150,
        [&](Random &random)
        {
            const RandomWorld<TypeParam> world(random);
            SCOPED_TRACE(toPicture(*world.occupancy));
            for (const int reach : TypeParam::reaches())
                for (const LengthMetric metric : {LengthMetric::Euclidean, LengthMetric::Lattice})
                {
                    const auto cost = [&](OffsetCoord from, OffsetCoord to)
                    {
                        return metric == LengthMetric::Lattice ? TypeParam::steps(from, to)
                                                               : lengthBetween(world.lattice, from, to);
                    };
                    const auto least = this->costsToGoal(world, reach, cost);
                    const auto jumps = TypeParam::jumps(world.occupancy->layout(), reach, JumpRule::Safe);
                    for (const Guidance guidance : everyGuidance)
                    {
                        SCOPED_TRACE(toString(guidance) + std::string(", reach ") + std::to_string(reach));
                        const LatticeLengthWeight<Norm> weight(world.lattice, jumps, metric, guidance,
                                                               world.centre(world.start), world.centre(world.goal));
                        const double excess = this->worstExcess(world, weight, least);
                        if (guidance == Guidance::Cheng && metric == LengthMetric::Euclidean && jumps.rings() > 1)
                            overestimated += excess > 1e-9 ? 1 : 0;
                        else
                            ASSERT_LT(excess, 1e-9);
                        if (isConsistent(guidance))
                        {
                            ASSERT_LT(this->worstFall(world, jumps, weight), 1e-9);
                        }
                    }
                }
        });
    // D p with jumps that are shorter than their steps
    EXPECT_EQ(overestimated > 0, (std::is_same_v<TypeParam, HexKind>));
}

TYPED_TEST(GuidanceBounds, ofLengthsHoldForSafetyWeights)
{
    using Norm = typename TypeParam::Norm;
    forEachSeed(150,
                [&](Random &random)
                {
                    const RandomWorld<TypeParam> world(random);
                    SCOPED_TRACE(toPicture(*world.occupancy));
                    const SafetyWeights weights(*world.occupancy);
                    const auto cost = [&](OffsetCoord from, OffsetCoord to)
                    {
                        return lengthBetween(world.lattice, from, to) * weights.weight(to);
                    };
                    for (const int reach : TypeParam::reaches())
                    {
                        const auto least = this->costsToGoal(world, reach, cost);
                        const auto jumps = TypeParam::jumps(world.occupancy->layout(), reach, JumpRule::Safe);
                        for (const Guidance guidance : everyGuidance)
                        {
                            if (guidance == Guidance::Cheng && jumps.rings() > 1)
                                continue;
                            SCOPED_TRACE(toString(guidance) + std::string(", reach ") + std::to_string(reach));
                            const SafetyLengthWeight<Norm> weight(world.lattice, jumps, weights, guidance,
                                                                  world.centre(world.start), world.centre(world.goal));
                            ASSERT_LT(this->worstExcess(world, weight, least), 1e-9);
                            if (isConsistent(guidance))
                            {
                                ASSERT_LT(this->worstFall(world, jumps, weight), 1e-9);
                            }
                        }
                    }
                });
}

/// The pilot quantity turns with the angle at the goal. Times D, which is no smooth norm, that makes the bound fall by
/// more than a step costs here and there, and closed cells must be reopened; times the straight distance it never does.
TYPED_TEST(GuidanceBounds, ofChengAreInconsistent)
{
    using Norm = typename TypeParam::Norm;
    double fall = 0.0;
    forEachSeed(50,
                [&](Random &random)
                {
                    const RandomWorld<TypeParam> world(random);
                    const auto jumps =
                        TypeParam::jumps(world.occupancy->layout(), TypeParam::reaches().front(), JumpRule::Safe);
                    const LatticeLengthWeight<Norm> weight(world.lattice, jumps, LengthMetric::Lattice, Guidance::Cheng,
                                                           world.centre(world.start), world.centre(world.goal));
                    fall = std::max(fall, this->worstFall(world, jumps, weight));
                });
    EXPECT_GT(fall, 1e-3);
}

TYPED_TEST(GuidanceBounds, theDistanceIsExactInOpenWater)
{
    using Norm = typename TypeParam::Norm;
    using KnownLattice = typename TypeParam::KnownLattice;
    // wide enough that no best path needs the rim, along which jumps touch the outside
    const KnownLattice lattice(Point(3.0, -4.0), 2.5, 25, 25);
    const auto open = occupancyWith(lattice, {});
    const OffsetCoord goal{12, 12};
    for (const int reach : TypeParam::reaches())
        for (const LengthMetric metric : {LengthMetric::Euclidean, LengthMetric::Lattice})
        {
            const auto cost = [&](OffsetCoord from, OffsetCoord to)
            {
                return metric == LengthMetric::Lattice ? TypeParam::steps(from, to) : lengthBetween(lattice, from, to);
            };
            const auto least =
                TypeParam::graph(*open, reach, JumpRule::Safe, cost).costsFrom({{vertexOf(lattice, goal), finish}});
            const auto jumps = TypeParam::jumps(open->layout(), reach, JumpRule::Safe);
            const LatticeLengthWeight<Norm> weight(lattice, jumps, metric, Guidance::Distance, Point::Zero(),
                                                   Point::Zero());
            for (std::int64_t row = 5; row < 20; ++row)
                for (std::int64_t column = 5; column < 20; ++column)
                {
                    const OffsetCoord cell{column, row};
                    ASSERT_NEAR(weight.bound(cell, {goal, finish}), least[vertexOf(lattice, cell)], 1e-9)
                        << "column " << column << ", row " << row << ", reach " << reach;
                }
        }
}

TYPED_TEST(GuidanceBounds, areWhatTheirNamesSay)
{
    using Norm = typename TypeParam::Norm;
    forEachSeed(100,
                [](Random &random)
                {
                    const RandomWorld<TypeParam> world(random);
                    const auto jumps =
                        TypeParam::jumps(world.occupancy->layout(), TypeParam::reaches().back(), JumpRule::Safe);
                    const OffsetCoord cell = toOffset(random.cellOf(world.lattice));
                    const Point start = world.centre(world.start);
                    const Point goal = world.centre(world.goal);
                    const double flight = lengthBetween(world.lattice, cell, world.goal);
                    const double p = pilotQuantity(start, goal, world.centre(cell));
                    const Norm norm(world.lattice, jumps);
                    for (const LengthMetric metric : {LengthMetric::Euclidean, LengthMetric::Lattice})
                    {
                        const auto bound = [&](Guidance guidance)
                        {
                            return LatticeLengthWeight<Norm>(world.lattice, jumps, metric, guidance, start, goal)
                                .bound(cell, {world.goal, finish});
                        };
                        ASSERT_EQ(bound(Guidance::None), 0.0);
                        ASSERT_NEAR(bound(Guidance::Euclidean), flight + finish, 1e-12);
                        ASSERT_NEAR(bound(Guidance::Wang), flight * p + finish, 1e-12);
                        ASSERT_NEAR(bound(Guidance::Cheng), norm.steps(cell, world.goal) * p + finish, 1e-12);
                        ASSERT_EQ(bound(Guidance::TieBreak), bound(Guidance::Distance));
                    }
                });
}
