// What becomes of a lattice's path where the problem's own checker is asked: it samples, it depends on the yaw, it
// throws.

#include <seahex/planning/HexAStar.h>
#include <seahex/planning/HexStateSpace.h>
#include <seahex/planning/OccupancyMotionValidator.h>
#include <seahex/planning/OccupancyValidityChecker.h>

#include "support/AsciiWorld.h"
#include "support/PlanningWorlds.h"

#include <ompl/base/PlannerData.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/lsan_interface.h>
#endif

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

const Box square{Point(0, 0), Point(20, 20)};

/// A random plane of discs, asked through OMPL's own validator, which samples.
struct SampledWorld
{
    explicit SampledWorld(Random &random, SpaceKind kind = SpaceKind::Plane)
        : discs(randomDiscs(random, square, 14)), si(userSpace(square, kind,
                                                               [this](const ob::State *state)
                                                               {
                                                                   ++calls;
                                                                   return discs.isFree(positionOf(si, state));
                                                               })),
          problem(problemBetween(si, freeAt(random), freeAt(random)))
    {
    }

    Point freeAt(Random &random) const
    {
        for (;;)
        {
            const Point p = random.pointIn(square);
            if (discs.isFree(p))
                return p;
        }
    }

    Discs discs;
    int calls = 0;
    ob::SpaceInformationPtr si;
    ob::ProblemDefinitionPtr problem;
};

std::shared_ptr<HexAStar> planner(const ob::ProblemDefinitionPtr &problem, bool anytime, bool smoothing)
{
    auto planner = plannerFor(problem);
    planner->setAnytime(anytime);
    planner->setSmoothing(smoothing);
    return planner;
}

TEST(HexAStarShortening, EveryMotionHoldsForAValidatorThatSamples)
{
    int shorter = 0;
    forEachSeed(60,
                [&](Random &random)
                {
                    const SampledWorld world(random, static_cast<SpaceKind>(random.integer(0, 2)));
                    if (planner(world.problem, false, false)->solve(5.0) != ob::PlannerStatus::EXACT_SOLUTION)
                        return;
                    const double lattice = pathOf(world.problem)->length();
                    world.problem->clearSolutionPaths();
                    ASSERT_EQ(planner(world.problem, true, true)->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
                    EXPECT_TRUE(pathOf(world.problem)->check());
                    EXPECT_LE(pathOf(world.problem)->length(), lattice);
                    shorter += pathOf(world.problem)->length() < 0.999 * lattice ? 1 : 0;
                });
    EXPECT_GT(shorter, 20);
}

TEST(HexAStarShortening, ManyShortCallsComeToTheSameEndAsOneLong)
{
    forEachSeed(8,
                [&](Random &random)
                {
                    SampledWorld world(random);
                    const auto whole = planner(world.problem, true, true);
                    if (whole->solve(10.0) != ob::PlannerStatus::EXACT_SOLUTION)
                        return;
                    const double expected = pathOf(world.problem)->length();
                    const int once = world.calls;
                    world.calls = 0;
                    world.problem->clearSolutionPaths();
                    const auto slices = planner(world.problem, true, true);
                    const int looksEach = static_cast<int>(random.integer(3, 30));
                    int calls = 0;
                    for (; slices->outcome() != PlanningOutcome::Found; ++calls)
                    {
                        ASSERT_LT(calls, 100000);
                        int looks = 0;
                        slices->solve(ob::PlannerTerminationCondition([&] { return ++looks >= looksEach; }));
                    }
                    EXPECT_GT(calls, 3);
                    EXPECT_EQ(pathOf(world.problem)->length(), expected);
                    EXPECT_LT(world.calls, 2 * once) << "nothing to speak of is asked twice";
                });
}

TEST(HexAStarShortening, OneRingFirstTakesNothingFromTheSearchWithAll)
{
    // a narrow vessel that may not lie across the stream: motions depend on the yaw they begin with
    int found = 0;
    forEachSeed(60,
                [&](Random &random)
                {
                    const double stream = random.real(-3.0, 3.0);
                    SampledWorld world(random, SpaceKind::Pose);
                    world.si->setStateValidityChecker(
                        [&](const ob::State *state)
                        {
                            const double yaw = state->as<ob::SE2StateSpace::StateType>()->getYaw();
                            return std::cos(yaw - stream) > -0.6 && world.discs.isFree(positionOf(world.si, state));
                        });
                    world.si->setup();
                    const auto plain = planner(world.problem, false, false);
                    const ob::PlannerStatus::StatusType status = plain->solve(300.0);
                    const double cost = pathOf(world.problem) ? pathOf(world.problem)->length() : 0.0;
                    world.problem->clearSolutionPaths();
                    const auto anytime = planner(world.problem, true, false);
                    const ob::PlannerStatus::StatusType same = anytime->solve(300.0);
                    if (status == ob::PlannerStatus::EXACT_SOLUTION)
                    {
                        ++found;
                        EXPECT_EQ(same, ob::PlannerStatus::EXACT_SOLUTION);
                        EXPECT_LE(pathOf(world.problem)->length(), cost);
                        EXPECT_TRUE(pathOf(world.problem)->check());
                    }
                });
    EXPECT_GT(found, 15);
}

TEST(HexAStarShortening, AnExceptionOfTheCheckerLeavesNoTrace)
{
    forEachSeed(20,
                [&](Random &random)
                {
                    SampledWorld world(random);
                    const auto calm = planner(world.problem, true, true);
                    if (calm->solve(5.0) != ob::PlannerStatus::EXACT_SOLUTION)
                        return;
                    const double expected = pathOf(world.problem)->length();
                    int left = static_cast<int>(random.integer(1, world.calls));
                    world.si->setStateValidityChecker(
                        [&](const ob::State *state)
                        {
                            if (--left == 0)
                                throw std::runtime_error("out of order");
                            return world.discs.isFree(positionOf(world.si, state));
                        });
                    world.si->setup();
                    world.problem->clearSolutionPaths();
                    const auto startled = planner(world.problem, true, true);
#if defined(__SANITIZE_ADDRESS__)
                    // OMPL's DiscreteMotionValidator loses its working state where a checker throws
                    __lsan_disable();
#endif
                    try
                    {
                        startled->solve(5.0);
                    }
                    catch (const std::runtime_error &)
                    {
                    }
#if defined(__SANITIZE_ADDRESS__)
                    __lsan_enable();
#endif
                    world.problem->clearSolutionPaths();
                    ASSERT_EQ(startled->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
                    EXPECT_EQ(pathOf(world.problem)->length(), expected);
                });
}

TEST(HexAStarLattice, ASpaceOfTooManyCellsToAskAboutIsRefused)
{
    const auto si = std::make_shared<ob::SpaceInformation>(
        std::make_shared<HexStateSpace>(HexLattice(Point(0, 0), 1.0, 40000, 40000)));
    si->setStateValidityChecker([](const ob::State *) { return true; });
    si->setup();
    const auto planner = plannerFor(problemBetween(si, Point(5, -5), Point(9, -9)));
    EXPECT_THROW(planner->solve(1.0), ompl::Exception);
}

TEST(HexAStarLattice, FarFromTheOriginEveryMotionStillHolds)
{
    forEachSeed(30,
                [&](Random &random)
                {
                    const double far = std::pow(10.0, random.real(5.0, 9.0));
                    const HexLattice lattice(Point(far, -far), 1.0, 12, 12);
                    const auto occupancy = randomOccupancy(random, lattice, 0.2);
                    const auto si = chartSpace(occupancy, random.chance(0.5) ? SpaceKind::Cells : SpaceKind::Plane);
                    const auto problem =
                        problemBetween(si, freePoint(random, *occupancy), freePoint(random, *occupancy));
                    const ob::PlannerStatus::StatusType status = planner(problem, true, true)->solve(5.0);
                    EXPECT_TRUE(status != ob::PlannerStatus::EXACT_SOLUTION || pathOf(problem)->check())
                        << "origin " << far;
                });
}

TEST(HexAStarLattice, AStartThatIsTheGoalIsAMotionAndBothVertices)
{
    const auto occupancy = occupancyWith(HexLattice(Point(0, 0), 1.0, 5, 5), {});
    const auto si = chartSpace(occupancy, SpaceKind::Cells);
    const Point goal = occupancy->lattice().centre(toCube({2, 2}));
    const auto problem = problemBetween(si, occupancy->lattice().centre(toCube({0, 0})), goal);
    problem->addStartState(stateAt(si, goal));
    problem->setOptimizationObjective(std::make_shared<ob::MaximizeMinClearanceObjective>(si));
    const auto planner = plannerFor(problem);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(pathOf(problem)->getStateCount(), 2u);
    EXPECT_TRUE(std::isfinite(pathOf(problem)->cost(problem->getOptimizationObjective()).value()));
    ob::PlannerData data(si);
    planner->getPlannerData(data);
    EXPECT_GE(data.numStartVertices(), 1u);
    EXPECT_EQ(data.numGoalVertices(), 1u);
}

}  // namespace
}  // namespace seahex::test
