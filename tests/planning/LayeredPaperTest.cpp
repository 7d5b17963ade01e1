#include "planning/Dive.h"

#include <seahex/planning/AntColony.h>
#include <seahex/planning/LayeredPlanner.h>
#include <seahex/slices/ExactSelection.h>
#include <seahex/slices/HeightMap.h>

#include <ompl/util/Console.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

// The experiment of [Xu]: 25 x 25 x 25, from [1, 8, 6] to [25, 23, 10], K = 0.5, planes across x; the terrain is not
// published, so hills at random.

using Eigen::Vector3d;

const Vector3d start(1, 8, 6);
const Vector3d goal(25, 23, 10);
const Eigen::AlignedBox3d cube(Vector3d(1, 1, 1), Vector3d(25, 25, 25));

struct Experiment
{
    explicit Experiment(std::uint64_t seed) : hills(randomHills(25, seed, {start, goal}))
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
        si = waterColumn(cube, [this](const Vector3d &p) { return p.z() > hills.height(p.x(), p.y()); });
    }

    template <class Planner>
    std::shared_ptr<Planner> planner() const
    {
        auto made = std::make_shared<Planner>(si);
        made->setAxis("x");
        return made;
    }

    HeightMap hills;
    ob::SpaceInformationPtr si;
};

TEST(LayeredPaper, ExactIsNeverWorseAndOptimisationNeverLengthens)
{
    int both = 0;
    int deadEnds = 0;
    int saved = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Experiment experiment(seed);
        const auto greedy = experiment.planner<LayeredPlanner>();
        const auto exact = experiment.planner<LayeredPlanner>();
        greedy->setMode(LayeredPlanner::Mode::Greedy);
        for (const auto &planner : {greedy, exact})
        {
            const auto problem = dive(experiment.si, start, {goal});
            if (solve(*planner, problem) != ob::PlannerStatus::EXACT_SOLUTION)
            {
                EXPECT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
                ASSERT_EQ(planner->deadEnds().size(), 1u);
                continue;
            }
            const std::vector<Vector3d> path = solutionOf(problem);
            const SliceSelection &selection = *planner->selection();
            EXPECT_EQ(path, selection.kept);
            EXPECT_LE(lengthOf(path), lengthOf(selection.points) + 1e-9);
            for (std::size_t i = 0; i < selection.points.size(); ++i)
                EXPECT_EQ(selection.points[i].x(), static_cast<double>(i + 1));
            for (std::size_t i = 1; i < path.size(); ++i)
                for (double t = 0.0; t <= 1.0; t += 0.002)
                {
                    const Vector3d p = path[i - 1] + t * (path[i] - path[i - 1]);
                    // the motion validator looks every 0.17, and slopes reach 5 : 1
                    ASSERT_GT(p.z(), experiment.hills.height(p.x(), p.y()) - 0.45);
                }
        }
        if (greedy->selection())
        {
            ++both;
            ASSERT_TRUE(exact->selection());
            EXPECT_LE(exact->selection()->figures.total, greedy->selection()->figures.total + 1e-9);
        }
        else
        {
            ++deadEnds;
            saved += exact->selection() ? 1 : 0;
        }
    }
    EXPECT_GT(both, 5);
    EXPECT_GT(deadEnds, 2) << "the published selection walks into dead ends";
    EXPECT_GT(saved, 2) << "where there is a path";
}

/// The same slices, made by the paper's own words: blocked up to the height's integer part plus one.
TEST(LayeredPaper, SlicesAreThoseOfThePaper)
{
    /// Asks the problem's motion validator.
    class Validator : public LegJudge
    {
    public:
        explicit Validator(ob::SpaceInformationPtr si) : si_(std::move(si)) {}
        Answer judge(const Vector3d &from, const Vector3d &to) override
        {
            const bool isValid = si_->checkMotion(stateAt(si_, from).get(), stateAt(si_, to).get());
            return isValid ? Answer::Valid : Answer::Invalid;
        }
        bool isOver() override { return false; }

    private:
        ob::SpaceInformationPtr si_;
    };

    for (std::uint64_t seed = 30; seed < 36; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Experiment experiment(seed);
        SliceStack stack(*SliceFrame::between(start, goal, cube, {25, 25, 25}, SliceAxis::X));
        for (int x = 1; x <= 25; ++x)
            for (int y = 1; y <= 25; ++y)
                for (int z = 1; z <= std::min(25.0, std::floor(experiment.hills.at(x, y)) + 1.0); ++z)
                    stack.block(x - 1, {y - 1, z - 1});
        const SliceProblem problem(stack, {});
        ExactSelection search(problem);
        Validator validator(experiment.si);
        search.work(validator);
        const auto planner = experiment.planner<LayeredPlanner>();
        solve(*planner, dive(experiment.si, start, {goal}));
        ASSERT_EQ(planner->selection().has_value(), search.best().has_value());
        if (!search.best())
            continue;
        EXPECT_EQ(planner->selection()->points, problem.positions(*search.best()));
        EXPECT_EQ(planner->selection()->figures.total, problem.figures(*search.best()).total);
    }
}

/// A world turned by a right angle has the same answers, along the course as well.
TEST(LayeredPaper, TheWorldMayBeTurned)
{
    const auto turned = [](const Vector3d &p)
    {
        return Vector3d(26.0 - p.y(), p.x(), p.z());
    };
    for (std::uint64_t seed = 40; seed < 46; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Experiment experiment(seed);
        const auto other =
            waterColumn(cube, [&](const Vector3d &p) { return p.z() > experiment.hills.height(p.y(), 26.0 - p.x()); });
        for (const std::string axis : {"course", "x"})
        {
            const auto planner = experiment.planner<LayeredPlanner>();
            LayeredPlanner second(other);
            planner->setAxis(axis);
            second.setAxis(axis == "x" ? "y" : axis);
            solve(*planner, dive(experiment.si, start, {goal}));
            solve(second, dive(other, turned(start), {turned(goal)}));
            ASSERT_EQ(planner->selection().has_value(), second.selection().has_value());
            if (!planner->selection())
                continue;
            EXPECT_NEAR(planner->selection()->figures.total, second.selection()->figures.total, 1e-6);
        }
    }
}

TEST(LayeredPaper, AntsAreNoBetterThanExact)
{
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Experiment experiment(seed);
        const auto exact = experiment.planner<LayeredPlanner>();
        const auto ants = experiment.planner<AntColony>();
        ants->setIterations(20);
        solve(*exact, dive(experiment.si, start, {goal}));
        const auto problem = dive(experiment.si, start, {goal});
        if (solve(*ants, problem) != ob::PlannerStatus::EXACT_SOLUTION)
            continue;
        ++found;
        ASSERT_TRUE(exact->selection());
        EXPECT_GE(ants->selection()->figures.total, exact->selection()->figures.total - 1e-9);
        EXPECT_TRUE(problem->getSolutionPath()->check());
        EXPECT_LE(lengthOf(solutionOf(problem)), lengthOf(ants->selection()->kept) + 1e-9);
    }
    EXPECT_GT(found, 2);
}

}  // namespace
}  // namespace seahex::test
