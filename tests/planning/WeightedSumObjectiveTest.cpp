#include <seahex/planning/AdmissibleHeuristic.h>
#include <seahex/planning/ClearanceObjective.h>
#include <seahex/planning/LatticeLengthObjective.h>
#include <seahex/planning/SafetyWeightObjective.h>
#include <seahex/planning/TurnAngleObjective.h>
#include <seahex/planning/TurnCountObjective.h>
#include <seahex/planning/WeightedSumObjective.h>

#include "planning/MotionCosts.h"
#include "support/AsciiWorld.h"
#include "support/ExplicitGraph.h"
#include "support/HexOracle.h"

#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/MinimaxObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

using Part = WeightedSumObjective::Part;

class WeightedSum : public ::testing::Test
{
protected:
    double bound(const ob::OptimizationObjective &objective) const
    {
        return admissibleHeuristic(objective, stateAt(si, world.centre('A')).get(),
                                   stateAt(si, world.centre('B')).get())
            .value();
    }
    static std::shared_ptr<ob::MultiOptimizationObjective> omplSum(const ob::SpaceInformationPtr &si,
                                                                   const std::vector<Part> &parts)
    {
        auto sum = std::make_shared<ob::MultiOptimizationObjective>(si);
        for (const auto &[objective, weight] : parts)
            sum->addObjective(objective, weight);
        return sum;
    }

    const AsciiWorld world{R"(
         . . . . . . .
        . A . # . B .
         . . . # . . .
        . . . . . . .
    )"};
    const ob::SpaceInformationPtr si = chartSpace(world.shared());
    const ob::OptimizationObjectivePtr length = std::make_shared<ob::PathLengthOptimizationObjective>(si);
    const ob::OptimizationObjectivePtr safety = std::make_shared<SafetyWeightObjective>(si, world.occupancy());
    const ob::OptimizationObjectivePtr onArrival =
        std::make_shared<SafetyWeightObjective>(si, world.occupancy(), SafetyCharge::OnArrival);
    const double straight = (world.centre('B') - world.centre('A')).norm();
};

TEST_F(WeightedSum, SumsAsOmplDoes)
{
    const std::vector<Part> parts = {{length, 0.3}, {safety, 2.0}, {onArrival, 0.7}};
    const WeightedSumObjective sum(si, parts);
    ASSERT_EQ(sum.getObjectiveCount(), 3u);
    const auto reference = omplSum(si, parts);
    Random random(3);
    for (int i = 0; i < 100; ++i)
    {
        const Point a = anyPoint(random, world.lattice());
        const Point b = anyPoint(random, world.lattice());
        const double expected =
            0.3 * motionCost(*length, a, b) + 2.0 * motionCost(*safety, a, b) + 0.7 * motionCost(*onArrival, a, b);
        EXPECT_NEAR(motionCost(sum, a, b), expected, 1e-12);
        EXPECT_EQ(motionCost(sum, a, b), motionCost(*reference, a, b));
    }
}

TEST_F(WeightedSum, TheBoundIsTheSumOfTheParts)
{
    EXPECT_NEAR(bound(WeightedSumObjective(si, {{length, 0.5}, {safety, 2.0}})), 2.5 * straight, 1e-7);
    EXPECT_NEAR(bound(*omplSum(si, {{length, 0.5}, {safety, 2.0}})), 2.5 * straight, 1e-7);
    EXPECT_NEAR(bound(*(0.5 * length + 2.0 * safety)), 2.5 * straight, 1e-7);
    // a sum within a sum
    EXPECT_NEAR(bound(*omplSum(si, {{omplSum(si, {{length, 1.0}, {safety, 1.0}}), 3.0}, {length, 1.0}})),
                7.0 * straight, 1e-7);
    EXPECT_NEAR(bound(*length), straight, 1e-7);
    EXPECT_EQ(bound(WeightedSumObjective(si)), 0.0);
    // which OMPL does not know
    EXPECT_EQ(heuristic(*omplSum(si, {{length, 0.5}, {safety, 2.0}}), world.centre('A'), world.centre('B')), 0.0);
}

/// What is gathered under way: it adds up, and more is better.
class Harvest : public ob::PathLengthOptimizationObjective
{
public:
    using PathLengthOptimizationObjective::PathLengthOptimizationObjective;
    bool isCostBetterThan(ob::Cost c1, ob::Cost c2) const override { return c1.value() > c2.value(); }
};

TEST_F(WeightedSum, WhereAPartDoesNotAddUpOrAWeightIsNegativeTheBoundIsIdentity)
{
    const auto widest = std::make_shared<ob::MaximizeMinClearanceObjective>(si);
    const auto minimax = std::make_shared<ob::MinimaxObjective>(si);
    for (const Part &other :
         {Part{widest, 1.0}, Part{minimax, 1.0}, Part{std::make_shared<Harvest>(si), 1.0}, Part{safety, -0.1}})
    {
        EXPECT_EQ(bound(WeightedSumObjective(si, {{length, 1.0}, other})), 0.0);
        EXPECT_EQ(bound(*omplSum(si, {other, {length, 1.0}})), 0.0);
    }
    // of an inner sum nothing but identity is known, of the outer one the rest
    const auto inner = omplSum(si, {{length, 1.0}, {minimax, 1.0}});
    EXPECT_NEAR(bound(WeightedSumObjective(si, {{length, 1.0}, {inner, 1.0}})), straight, 1e-7);
}

/// A sum that a user made into another thing.
class SquaredSum : public ob::MultiOptimizationObjective
{
public:
    using MultiOptimizationObjective::MultiOptimizationObjective;
    ob::Cost motionCost(const ob::State *s1, const ob::State *s2) const override
    {
        const double sum = MultiOptimizationObjective::motionCost(s1, s2).value();
        return ob::Cost(sum * sum);
    }
    ob::Cost motionCostHeuristic(const ob::State *, const ob::State *) const override { return ob::Cost(0.125); }
};

TEST_F(WeightedSum, AUsersOwnSumIsAskedItself)
{
    SquaredSum sum(si);
    sum.addObjective(length, 1.0);
    EXPECT_EQ(bound(sum), 0.125);
}

TEST_F(WeightedSum, SymmetricIfEveryPartWithAWeightIs)
{
    EXPECT_TRUE(WeightedSumObjective(si, {{length, 1.0}, {safety, 1.0}}).isSymmetric());
    EXPECT_FALSE(WeightedSumObjective(si, {{length, 1.0}, {onArrival, 0.1}}).isSymmetric());
    EXPECT_TRUE(WeightedSumObjective(si, {{length, 1.0}, {onArrival, 0.0}}).isSymmetric());
    EXPECT_TRUE(omplSum(si, {{length, 1.0}, {onArrival, 1.0}})->isSymmetric()) << "what OMPL's own believes";
}

TEST_F(WeightedSum, TwoThreadsMayAsk)
{
    expectSameFromTwoThreads(WeightedSumObjective(si, {{length, 1.0}, {safety, 0.5}, {onArrival, 2.0}}),
                             world.lattice());
}

/// A random world and a random sum on it, in R^2 or SE(2); of OMPL's class or of ours.
struct RandomProblem
{
    explicit RandomProblem(Random &random)
        : occupancy(randomOccupancy(random,
                                    HexLattice(Point(random.real(-50, 50), random.real(-50, 50)), random.real(0.3, 3.0),
                                               random.integer(5, 8), random.integer(5, 8)),
                                    random.real(0.0, 0.35))),
          hasHeading(random.chance(0.5)), si(chartSpace(occupancy, hasHeading ? SpaceKind::Pose : SpaceKind::Plane))
    {
        const double pitch = occupancy->lattice().pitch();
        std::vector<ob::OptimizationObjectivePtr> all = {
            std::make_shared<ob::PathLengthOptimizationObjective>(si),
            std::make_shared<LatticeLengthObjective>(si, occupancy->lattice()),
            std::make_shared<SafetyWeightObjective>(si, *occupancy, SafetyCharge::AlongLine),
            std::make_shared<SafetyWeightObjective>(si, *occupancy, SafetyCharge::OnArrival),
            std::make_shared<ClearanceObjective>(si, *occupancy, random.real(0.0, 4.0) * pitch, random.real(0.0, 5.0))};
        if (hasHeading)
        {
            all.push_back(std::make_shared<TurnAngleObjective>(si));
            all.push_back(std::make_shared<TurnCountObjective>(si));
        }
        const auto ours = std::make_shared<WeightedSumObjective>(si);
        sum = random.chance(0.5) ? ours : std::make_shared<ob::MultiOptimizationObjective>(si);
        for (const ob::OptimizationObjectivePtr &part : all)
            if (random.chance(0.6))
                sum->addObjective(part, random.chance(0.2) ? 0.0 : random.real(0.0, 3.0));
    }

    std::shared_ptr<const HexOccupancy> occupancy;
    bool hasHeading;
    ob::SpaceInformationPtr si;
    std::shared_ptr<ob::MultiOptimizationObjective> sum;
};

TEST(AdmissibleHeuristic, NoPathOfAnyKindCostsLess)
{
    for (std::uint64_t seed = 1; seed <= 2000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const RandomProblem problem(random);
        const HexLattice &lattice = problem.occupancy->lattice();
        og::PathGeometric path(problem.si);
        for (std::int64_t i = random.integer(2, 8); i > 0; --i)
            path.append(
                stateAt(problem.si, random.pointOf(lattice, random.cellOf(lattice)), random.real(-3.1, 3.1)).get());
        // the straight motion itself, cut in places, now and then
        if (random.chance(0.3))
        {
            path.keepAfter(path.getState(path.getStateCount() - 2));
            path.interpolate(static_cast<unsigned int>(random.integer(3, 20)));
        }
        const double bound =
            admissibleHeuristic(*problem.sum, path.getState(0), path.getState(path.getStateCount() - 1)).value();
        ASSERT_LE(bound, path.cost(problem.sum).value());
    }
}

TEST(AdmissibleHeuristic, TheCheapestPathOfTheLatticeCostsNoLess)
{
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
    {
        Random random(seed);
        const RandomProblem problem(random);
        const HexLattice &lattice = problem.occupancy->lattice();
        SCOPED_TRACE(random.seedText() + toPicture(*problem.occupancy));
        // in SE(2) with yaws that never change, which leaves the objectives their turns
        const ExplicitGraph graph =
            jumpGraph(*problem.occupancy, static_cast<int>(random.integer(1, 3)),
                      [&](HexCoord from, HexCoord to)
                      { return motionCost(*problem.sum, lattice.centre(from), lattice.centre(to)); });
        const HexCoord start = random.cellOf(lattice);
        const std::vector<double> costs = graph.costsFrom({{vertexOf(lattice, start), 0.0}});
        forEachCell(lattice, 0,
                    [&](HexCoord goal)
                    {
                        const double cost = costs[vertexOf(lattice, goal)];
                        if (std::isinf(cost))
                            return;
                        ++compared;
                        const double bound =
                            admissibleHeuristic(*problem.sum, stateAt(problem.si, lattice.centre(start)).get(),
                                                stateAt(problem.si, lattice.centre(goal)).get())
                                .value();
                        ASSERT_LE(bound, cost);
                    });
    }
    EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace seahex::test
