#include "planning/Dive.h"

#include <seahex/planning/AntColony.h>
#include <seahex/planning/LayeredPlanner.h>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/Console.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

const AlignedBox3d basin(Vector3d(-10, -8, 0), Vector3d(12, 9, 6));

Vector3d placeIn(Random &random, const AlignedBox3d &box)
{
    Vector3d p;
    for (int k = 0; k < 3; ++k)
        p[k] = random.real(box.min()[k], box.max()[k]);
    return p;
}

/// Boulders at random.
struct Boulders
{
    std::vector<Vector3d> centres;

    static constexpr double radius = 1.2;

    explicit Boulders(Random &random)
    {
        for (int i = 0; i < 25; ++i)
            centres.push_back(placeIn(random, basin));
    }
    double clearance(const Vector3d &p) const
    {
        double least = 100.0;
        for (const Vector3d &centre : centres)
            least = std::min(least, (p - centre).norm() - radius);
        return least;
    }
    bool isFree(const Vector3d &p) const { return clearance(p) > 0.0; }
    Vector3d freePlace(Random &random) const
    {
        for (;;)
        {
            Vector3d p = placeIn(random, basin);
            if (clearance(p) > 0.2)
                return p;
        }
    }
};

template <class Planner>
std::shared_ptr<Planner> plannerOf(const ob::SpaceInformationPtr &si)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    auto planner = std::make_shared<Planner>(si);
    planner->setSlices(9);
    planner->setAcross(12);
    planner->setLevels(6);
    return planner;
}

/// In every direction: slices at equal distances across the course, and a path that an independent check holds valid.
template <class Planner>
void checkEveryDirection()
{
    int solved = 0;
    int optimised = 0;
    forEachSeed(40,
                [&](Random &random)
                {
                    const Boulders boulders(random);
                    const auto si = waterColumn(basin, [&](const Vector3d &p) { return boulders.isFree(p); });
                    const Vector3d start = boulders.freePlace(random);
                    const Vector3d goal = boulders.freePlace(random);
                    const auto planner = plannerOf<Planner>(si);
                    const auto problem = dive(si, start, {goal});
                    if (solve(*planner, problem) != ob::PlannerStatus::EXACT_SOLUTION)
                    {
                        EXPECT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
                        EXPECT_EQ(planner->deadEnds().size(), 1u);
                        return;
                    }
                    ++solved;
                    EXPECT_EQ(planner->outcome(), PlanningOutcome::Found);
                    EXPECT_TRUE(planner->deadEnds().empty());
                    const std::vector<Vector3d> path = solutionOf(problem);
                    EXPECT_EQ(path.front(), start);
                    EXPECT_EQ(path.back(), goal);
                    for (std::size_t i = 1; i < path.size(); ++i)
                        for (int k = 0; k <= 1000; ++k)
                        {
                            const Vector3d p = path[i - 1] + 0.001 * k * (path[i] - path[i - 1]);
                            // OMPL's validator looks every 0.1: between two looks a path may cut into a boulder by
                            // 0.05^2 / (2 r)
                            ASSERT_GT(boulders.clearance(p), -0.002) << "leg " << i;
                            ASSERT_TRUE(basin.contains(p)) << "leg " << i;
                        }

                    ASSERT_TRUE(planner->selection());
                    const SliceSelection &selection = *planner->selection();
                    ASSERT_EQ(selection.points.size(), 9u);
                    const Vector3d course = Vector3d(goal.x() - start.x(), goal.y() - start.y(), 0).normalized();
                    for (std::size_t i = 0; i < 9; ++i)
                        EXPECT_NEAR((selection.points[i] - start).dot(course),
                                    static_cast<double>(i) / 8.0 * (goal - start).dot(course), 1e-9);
                    EXPECT_NEAR(selection.figures.length, lengthOf(selection.points), 1e-9);
                    EXPECT_NEAR(selection.keptFigures.length, lengthOf(selection.kept), 1e-9);
                    EXPECT_LE(selection.keptFigures.length, selection.figures.length + 1e-9);
                    EXPECT_LE(selection.keptFigures.total, selection.figures.total + 1e-9);
                    optimised += selection.kept.size() < 9 ? 1 : 0;
                });
    EXPECT_GT(solved, 30);
    EXPECT_GT(optimised, 30);
}

TEST(SlicePlanner, LayeredDivesInEveryDirection)
{
    checkEveryDirection<LayeredPlanner>();
}

TEST(SlicePlanner, AntsDiveInEveryDirection)
{
    checkEveryDirection<AntColony>();
}

/// Steeper than 1 : 1 a vehicle may dive, not climb: a motion and the one back are two.
class ClimbLimit : public ob::MotionValidator
{
public:
    explicit ClimbLimit(const ob::SpaceInformationPtr &si) : ob::MotionValidator(si) {}

    bool checkMotion(const ob::State *a, const ob::State *b) const override
    {
        const Vector3d way = placeOf(b) - placeOf(a);
        return way.z() <= way.head<2>().norm() && si_->isValid(b);
    }
    bool checkMotion(const ob::State *a, const ob::State *b, std::pair<ob::State *, double> &) const override
    {
        return checkMotion(a, b);
    }
};

TEST(SlicePlanner, EveryMotionIsValidInItsDirection)
{
    int steep = 0;
    forEachSeed(30,
                [&](Random &random)
                {
                    const Boulders boulders(random);
                    const auto si = waterColumn(
                        basin, [&](const Vector3d &p) { return boulders.isFree(p); },
                        [](const auto &space) { return std::make_shared<ClimbLimit>(space); });
                    const std::vector<std::shared_ptr<SlicePlanner>> planners = {plannerOf<LayeredPlanner>(si),
                                                                                 plannerOf<AntColony>(si)};
                    const Vector3d start = boulders.freePlace(random);
                    const Vector3d goal = boulders.freePlace(random);
                    for (const auto &planner : planners)
                        for (const bool optimise : {false, true})
                        {
                            planner->setOptimise(optimise);
                            const auto problem = dive(si, start, {goal});
                            if (solve(*planner, problem) != ob::PlannerStatus::EXACT_SOLUTION)
                                continue;
                            EXPECT_TRUE(problem->getSolutionPath()->check()) << planner->getName();
                            const std::vector<Vector3d> path = solutionOf(problem);
                            for (std::size_t i = 1; i < path.size(); ++i)
                            {
                                const Vector3d way = path[i] - path[i - 1];
                                EXPECT_LE(way.z(), way.head<2>().norm()) << planner->getName();
                                steep += way.z() < -way.head<2>().norm() ? 1 : 0;
                            }
                        }
                });
    EXPECT_GT(steep, 10);
}

/// A wall with no gap, between the fourth plane and the fifth, or on the fourth.
TEST(SlicePlanner, DeadEndsAreTold)
{
    for (const double wall : {2.0, 1.0})
    {
        const auto si = waterColumn(basin, [&](const Vector3d &p) { return std::abs(p.x() - wall) > 0.35; });
        const int plane = wall > 1.0 ? 5 : 4;  // of those at x = -7, -5, ... 9
        const std::vector<std::shared_ptr<SlicePlanner>> planners = {
            plannerOf<LayeredPlanner>(si), plannerOf<LayeredPlanner>(si), plannerOf<AntColony>(si)};
        std::static_pointer_cast<LayeredPlanner>(planners[1])->setMode("greedy");
        for (const auto &planner : planners)
        {
            const auto problem = dive(si, {-7, 0, 3}, {{9, 0, 3}, {9, 2, 3}});
            for (int i = 0; i < 2; ++i)
            {
                EXPECT_EQ(solve(*planner, problem), ob::PlannerStatus::TIMEOUT);
                EXPECT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
                ASSERT_EQ(planner->deadEnds().size(), 2u);
                EXPECT_EQ(planner->deadEnds()[0].plane, plane);
                EXPECT_EQ(planner->deadEnds()[0].planes, 9);
                EXPECT_EQ(planner->deadEnds()[1].goal, 1u);
                EXPECT_FALSE(planner->selection());
            }
            planner->clear();
            EXPECT_TRUE(planner->deadEnds().empty());
        }
    }
}

TEST(SlicePlanner, StraightUpThereIsOneWay)
{
    const auto si = waterColumn(basin, [](const Vector3d &p) { return (p - Vector3d(3, 3, 3)).norm() > 1.0; });
    const auto planner = plannerOf<LayeredPlanner>(si);
    const auto free = dive(si, {0, 0, 1}, {{0, 0, 5}});
    EXPECT_EQ(solve(*planner, free), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(solutionOf(free), (std::vector<Vector3d>{{0, 0, 1}, {0, 0, 5}}));
    EXPECT_FALSE(planner->selection());
    const auto barred = dive(si, {3, 3, 1}, {{3, 3, 5}});
    EXPECT_EQ(solve(*planner, barred), ob::PlannerStatus::TIMEOUT);
    EXPECT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
    ASSERT_EQ(planner->deadEnds().size(), 1u);
    EXPECT_EQ(planner->deadEnds()[0].plane, 1);
    planner->setAxis("x");
    const auto aside = dive(si, {3, 0, 3}, {{3, 5, 3}});
    EXPECT_EQ(solve(*planner, aside), ob::PlannerStatus::TIMEOUT) << "no room for planes along x";
    planner->setAxis("y");
    EXPECT_EQ(solve(*planner, aside), ob::PlannerStatus::EXACT_SOLUTION);
}

/// Of two goals the one that the objective finds better, as if each had been asked for alone.
TEST(SlicePlanner, TheBestPairWins)
{
    forEachSeed(20,
                [&](Random &random)
                {
                    const Boulders boulders(random);
                    const auto si = waterColumn(basin, [&](const Vector3d &p) { return boulders.isFree(p); });
                    const Vector3d start = boulders.freePlace(random);
                    const std::vector<Vector3d> goals = {boulders.freePlace(random), boulders.freePlace(random)};
                    double best = 1e9;
                    for (const Vector3d &goal : goals)
                    {
                        const auto alone = dive(si, start, {goal});
                        if (solve(*plannerOf<LayeredPlanner>(si), alone) == ob::PlannerStatus::EXACT_SOLUTION)
                            best = std::min(best, lengthOf(solutionOf(alone)));
                    }
                    const auto both = dive(si, start, goals);
                    const auto planner = plannerOf<LayeredPlanner>(si);
                    const bool solved = solve(*planner, both) == ob::PlannerStatus::EXACT_SOLUTION;
                    ASSERT_EQ(solved, best < 1e9);
                    if (!solved)
                        return;
                    EXPECT_NEAR(lengthOf(solutionOf(both)), best, 1e-9);
                });
}

/// Length, of which nothing is known beforehand: no pair is hopeless.
class PlainLength : public ob::PathLengthOptimizationObjective
{
public:
    using ob::PathLengthOptimizationObjective::PathLengthOptimizationObjective;
    ob::Cost motionCostHeuristic(const ob::State *, const ob::State *) const override { return ob::Cost(0.0); }
};

TEST(SlicePlanner, TheSelectionIsTheBestByF)
{
    int conflicts = 0;
    forEachSeed(60,
                [&](Random &random)
                {
                    const Boulders boulders(random);
                    const auto si = waterColumn(basin, [&](const Vector3d &p) { return boulders.isFree(p); });
                    const Vector3d start = boulders.freePlace(random);
                    const std::vector<Vector3d> goals = {boulders.freePlace(random), boulders.freePlace(random),
                                                         boulders.freePlace(random)};
                    const auto planner = plannerOf<LayeredPlanner>(si);
                    planner->setLengthWeight(0.1);
                    double least = 1e9;
                    for (const Vector3d &goal : goals)
                    {
                        solve(*planner, dive(si, start, {goal}));
                        if (planner->selection())
                            least = std::min(least, planner->selection()->figures.total);
                    }
                    const auto all = dive(si, start, goals);
                    all->setOptimizationObjective(std::make_shared<PlainLength>(si));
                    solve(*planner, all);
                    ASSERT_EQ(planner->selection().has_value(), least < 1e9);
                    if (!planner->selection())
                        return;
                    EXPECT_NEAR(planner->selection()->figures.total, least, 1e-9);
                    conflicts += planner->selection()->kept.back() == solutionOf(all).back() ? 0 : 1;
                });
    EXPECT_GT(conflicts, 0) << "F and the objective never disagreed";
}

TEST(SlicePlanner, HopelessPairsAreSkipped)
{
    const auto si = waterColumn(basin, [](const Vector3d &) { return true; });
    const auto planner = plannerOf<LayeredPlanner>(si);
    const auto problem = dive(si, {0, 0, 3}, {{2, 0, 3}, {9, 0, 3}, {0, 2.5, 3}});
    EXPECT_EQ(solve(*planner, problem), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(solutionOf(problem).back(), Vector3d(2, 0, 3));
    EXPECT_EQ(planner->outcome(), PlanningOutcome::Found);
    EXPECT_EQ(planner->getPlannerProgressProperties().at("points INTEGER")(), std::to_string(9 * 12 * 6));
}

TEST(SlicePlanner, KWeighsLengthAgainstDanger)
{
    int differing = 0;
    forEachSeed(20,
                [&](Random &random)
                {
                    const Boulders boulders(random);
                    const auto si = waterColumn(basin, [&](const Vector3d &p) { return boulders.isFree(p); });
                    const Vector3d start = boulders.freePlace(random);
                    const Vector3d goal = boulders.freePlace(random);
                    const auto planner = plannerOf<LayeredPlanner>(si);
                    const auto figuresFor = [&](double weight)
                    {
                        planner->setLengthWeight(weight);
                        solve(*planner, dive(si, start, {goal}));
                        return planner->selection() ? planner->selection()->figures : SliceFigures();
                    };
                    const SliceFigures safe = figuresFor(0.0);
                    const SliceFigures brief = figuresFor(1.0);
                    EXPECT_LE(safe.danger, brief.danger + 1e-9);
                    EXPECT_LE(brief.length, safe.length + 1e-9);
                    differing += safe.danger < brief.danger - 1e-9 ? 1 : 0;
                    planner->setVehicleLength(4.0);
                    EXPECT_NEAR(figuresFor(1.0).length, 0.25 * brief.length, 1e-9);
                });
    EXPECT_GT(differing, 10);
}

TEST(SlicePlanner, TheSeedIsTheAnts)
{
    Random random(8);
    const Boulders boulders(random);
    const auto si = waterColumn(basin, [&](const Vector3d &p) { return boulders.isFree(p); });
    const Vector3d start = boulders.freePlace(random);
    const Vector3d goal = boulders.freePlace(random);
    const auto pathOf = [&](unsigned int seed)
    {
        const auto planner = plannerOf<AntColony>(si);
        planner->setIterations(5);
        planner->setSeed(seed);
        solve(*planner, dive(si, start, {goal}));
        return planner->selection() ? planner->selection()->points : std::vector<Vector3d>();
    };
    EXPECT_EQ(pathOf(7), pathOf(7));
    EXPECT_NE(pathOf(7), pathOf(8));
    EXPECT_FALSE(pathOf(7).empty());
}

TEST(SlicePlanner, TooManyPointsAreRefused)
{
    const auto si = waterColumn(basin, [](const Vector3d &) { return true; });
    const auto planner = plannerOf<LayeredPlanner>(si);
    planner->setAcross(1000);
    planner->setLevels(1000);
    EXPECT_THROW(solve(*planner, dive(si, {0, 0, 1}, {{5, 0, 1}})), ompl::Exception);
    planner->setLevels(2);
    EXPECT_EQ(solve(*planner, dive(si, {0, 0, 1}, {{5, 0, 1}})), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST(SlicePlanner, AnExceptionOfTheUsersPassesThrough)
{
    int questions = 0;
    int bearable = 300;
    // OMPL's own motion validator would lose a state
    const auto si = waterColumn(
        basin,
        [&](const Vector3d &)
        {
            if (++questions > bearable)
                throw std::runtime_error("the sonar is broken");
            return true;
        },
        [](const auto &space) { return std::make_shared<ClimbLimit>(space); });
    for (const int many : {300, 9 * 12 * 6 + 5})  // while slices are laid, and while legs are asked for
    {
        questions = 0;
        bearable = many;
        const auto planner = plannerOf<LayeredPlanner>(si);
        const auto problem = dive(si, {-9, 0, 3}, {{11, 0, 3}});
        EXPECT_THROW(solve(*planner, problem), std::runtime_error);
        EXPECT_EQ(planner->getPlannerProgressProperties().at("points INTEGER")(), "0") << "not cleared";
        bearable = 1000000;
        EXPECT_EQ(solve(*planner, problem), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(solutionOf(problem).size(), 2u);
    }
}

}  // namespace
}  // namespace seahex::test
