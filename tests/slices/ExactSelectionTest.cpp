#include "slices/SliceWorlds.h"

#include <seahex/slices/ExactSelection.h>
#include <seahex/slices/GreedySelection.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace seahex::test
{
namespace
{

/// The least F over all paths, each of them made and weighed; infinity if there is none. Tells how far any got.
class EveryPath
{
public:
    EveryPath(const SliceProblem &problem, const RecordingJudge::Rule &isValid) : problem_(problem), isValid_(isValid)
    {
        extend(problem.frame().start());
    }

    double least() const { return least_; }
    int farthest() const { return farthest_; }

private:
    void extend(const Eigen::Vector3d &last)
    {
        const SliceFrame &frame = problem_.frame();
        const int plane = static_cast<int>(path_.size()) + 1;
        farthest_ = std::max(farthest_, plane - 1);
        if (plane + 1 == frame.planes())
        {
            if (isValid_(last, frame.goal()))
            {
                farthest_ = plane;
                least_ = std::min(least_, weighed());
            }
            return;
        }
        for (std::size_t i = 0; i < frame.cellCount(); ++i)
        {
            const Eigen::Vector3d next = frame.position(plane, frame.cell(i));
            if (!problem_.isOpen(plane, i) || !isValid_(last, next))
                continue;
            path_.push_back(frame.cell(i));
            extend(next);
            path_.pop_back();
        }
    }

    /// F by its definition.
    double weighed() const
    {
        const SliceCriterion &criterion = problem_.criterion();
        double length = 0.0;
        double danger = 0.0;
        Eigen::Vector3d last = problem_.frame().start();
        for (std::size_t i = 0; i < path_.size(); ++i)
        {
            const int plane = static_cast<int>(i) + 1;
            const Eigen::Vector3d next = problem_.frame().position(plane, path_[i]);
            length += (next - last).norm();
            danger += problem_.stack().danger(plane, path_[i], criterion.neighbourhood);
            last = next;
        }
        length += (problem_.frame().goal() - last).norm();
        return criterion.lengthWeight * length / criterion.vehicleLength + (1.0 - criterion.lengthWeight) * danger;
    }

    const SliceProblem &problem_;
    const RecordingJudge::Rule &isValid_;
    SlicePath path_;
    double least_ = std::numeric_limits<double>::infinity();
    int farthest_ = 0;
};

/// The first plane with no open point, or the last plane.
int firstClosedPlane(const SliceProblem &problem)
{
    for (int plane = 1; plane + 1 < problem.frame().planes(); ++plane)
    {
        bool isClosed = true;
        for (std::size_t i = 0; i < problem.frame().cellCount(); ++i)
            isClosed = isClosed && !problem.isOpen(plane, i);
        if (isClosed)
            return plane;
    }
    return problem.frame().planes() - 1;
}

TEST(ExactSelection, FindsTheLeastOfAllPaths)
{
    int found = 0;
    int lost = 0;
    int afterDetours = 0;
    forEachSeed(300,
                [&](Random &random)
                {
                    const int planes = static_cast<int>(random.integer(2, 5));
                    const SliceFrame frame = randomFrame(random, {planes, 3, 3});
                    const SliceStack stack = randomStack(random, frame, random.real(0.0, 0.5));
                    const SliceProblem problem(stack, randomCriterion(random));
                    const auto legs = randomLegs(random, random.real(0.05, 1.0));
                    const EveryPath all(problem, legs);
                    ExactSelection exact(problem);
                    RecordingJudge judge(legs);
                    finish(exact, judge);
                    ASSERT_EQ(exact.best().has_value(), std::isfinite(all.least()));
                    EXPECT_LE(judge.mostRepeats(), 1);
                    if (!exact.best())
                    {
                        ++lost;
                        const int closed = firstClosedPlane(problem);
                        EXPECT_EQ(exact.farthestPlane(), closed < planes - 1 ? closed - 1 : all.farthest());
                        EXPECT_TRUE(closed == planes - 1 || judge.legs() == 0);
                        return;
                    }
                    ++found;
                    afterDetours += judge.legs() > static_cast<std::size_t>(planes) ? 1 : 0;
                    expectUsable(problem, *exact.best(), legs);
                    EXPECT_NEAR(problem.figures(*exact.best()).total, all.least(), 1e-9 * (1.0 + all.least()));
                });
    EXPECT_GT(found, 80);
    EXPECT_GT(lost, 40);
    EXPECT_GT(afterDetours, 40);
}

TEST(ExactSelection, IsNeverWorseThanGreedy)
{
    int better = 0;
    int greedyLost = 0;
    forEachSeed(100,
                [&](Random &random)
                {
                    const SliceStack stack = randomStack(random, randomFrame(random, {8, 7, 6}), random.real(0.0, 0.6));
                    const SliceProblem problem(stack, randomCriterion(random));
                    const auto legs = randomLegs(random, random.real(0.05, 1.0));
                    GreedySelection greedy(problem);
                    ExactSelection exact(problem);
                    RecordingJudge first(legs);
                    RecordingJudge second(legs);
                    finish(greedy, first);
                    finish(exact, second);
                    EXPECT_GE(exact.farthestPlane(), greedy.farthestPlane());
                    if (!greedy.best())
                    {
                        greedyLost += exact.best() ? 1 : 0;
                        return;
                    }
                    ASSERT_TRUE(exact.best());
                    const double least = problem.figures(*exact.best()).total;
                    const double total = problem.figures(*greedy.best()).total;
                    EXPECT_LE(least, total + 1e-9 * (1.0 + total));
                    better += least < total - 1e-9 ? 1 : 0;
                });
    EXPECT_GT(better, 20);
    EXPECT_GT(greedyLost, 0);
}

/// Where every leg is valid no more of them are asked for than the path has.
TEST(ExactSelection, AsksForTheLegsThatMatter)
{
    forEachSeed(30,
                [](Random &random)
                {
                    const SliceStack stack = randomStack(random, randomFrame(random, {8, 7, 6}), 0.3);
                    SliceCriterion criterion = randomCriterion(random);
                    criterion.lengthWeight = 0.5;  // with neither length nor danger alone there are many equals
                    const SliceProblem problem(stack, criterion);
                    ExactSelection exact(problem);
                    RecordingJudge judge(everyLeg());
                    finish(exact, judge);
                    ASSERT_TRUE(exact.best());
                    EXPECT_LE(judge.legs(), 9u);
                });
}

/// Looking back from the goal asks for no legs and may take long all the same.
TEST(ExactSelection, LooksAtTheTimeBeforeItAsks)
{
    class Impatient : public LegJudge
    {
    public:
        Answer judge(const Eigen::Vector3d &, const Eigen::Vector3d &) override
        {
            ++legs;
            return Answer::Valid;
        }
        bool isOver() override { return ++looks % 3 == 0; }

        int legs = 0;
        int looks = 0;
    };
    Random random(3);
    const SliceProblem problem(SliceStack(randomFrame(random, {8, 20, 20})), {});
    ExactSelection exact(problem);
    Impatient judge;
    int interruptions = 0;
    for (SliceSearch::Step step; (step = exact.work(judge)) != SliceSearch::Step::Better;)
    {
        ASSERT_EQ(step, SliceSearch::Step::Interrupted);
        interruptions += judge.legs == 0 ? 1 : 0;
    }
    EXPECT_GT(interruptions, 10);
}

TEST(ExactSelection, InterruptionsChangeNothing)
{
    forEachSeed(60,
                [](Random &random)
                {
                    const SliceStack stack = randomStack(random, randomFrame(random, {6, 4, 4}), 0.3);
                    const SliceProblem problem(stack, randomCriterion(random));
                    const auto legs = randomLegs(random, random.real(0.1, 1.0));
                    ExactSelection atOnce(problem);
                    ExactSelection inPieces(problem);
                    RecordingJudge patient(legs);
                    RecordingJudge hasty(legs, 1);
                    finish(atOnce, patient);
                    EXPECT_GE(finish(inPieces, hasty), static_cast<int>(patient.legs()) - 1);
                    EXPECT_EQ(atOnce.best(), inPieces.best());
                    EXPECT_EQ(atOnce.farthestPlane(), inPieces.farthestPlane());
                    EXPECT_EQ(patient.legs(), hasty.legs());
                    EXPECT_LE(hasty.mostRepeats(), 1);
                });
}

}  // namespace
}  // namespace seahex::test
