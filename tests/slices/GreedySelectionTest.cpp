#include "slices/SliceWorlds.h"

#include <seahex/slices/GreedySelection.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

namespace seahex::test
{
namespace
{

using Eigen::Vector3d;

/// [Xu] eq. 6-9 as they are written, in coordinates of space: points that are 0 in the matrix and have D < 1, the one
/// with the least L = Lj + Lk, the reference line renewed after each plane.
std::optional<std::vector<Vector3d>> literalSelection(const SliceStack &stack, int neighbourhood)
{
    const SliceFrame &frame = stack.frame();
    const Vector3d goal = frame.goal();
    const Vector3d axis = frame.position(1, {0, 0}) - frame.position(0, {0, 0});
    std::vector<Vector3d> path = {frame.start()};
    for (int i = 1; i + 1 < frame.planes(); ++i)
    {
        const Vector3d last = path.back();
        double leastL = std::numeric_limits<double>::infinity();
        Vector3d chosen;
        for (int a = 0; a < frame.across(); ++a)
            for (int b = 0; b < frame.levels(); ++b)
            {
                int free = 0;
                for (int u = a - neighbourhood / 2; u <= a + neighbourhood / 2; ++u)
                    for (int v = b - neighbourhood / 2; v <= b + neighbourhood / 2; ++v)
                        if ((u != a || v != b) && u >= 0 && u < frame.across() && v >= 0 && v < frame.levels() &&
                            !stack.isBlocked(i, {u, v}))
                            ++free;
                if (stack.isBlocked(i, {a, b}) || free == 0)
                    continue;
                const Vector3d p = frame.position(i, {a, b});
                // the reference line and the plane through p across the axis
                const double t = (p - last).dot(axis) / (goal - last).dot(axis);
                const double lj = (p - last).norm();
                const double lk = (p - (last + t * (goal - last))).norm();
                if (lj + lk < leastL - 1e-12)
                {
                    leastL = lj + lk;
                    chosen = p;
                }
            }
        if (!std::isfinite(leastL))
            return std::nullopt;
        path.push_back(chosen);
    }
    path.push_back(goal);
    return path;
}

TEST(GreedySelection, ChoosesAsPublished)
{
    int found = 0;
    int lost = 0;
    forEachSeed(200,
                [&](Random &random)
                {
                    const SliceFrame frame = randomFrame(random, {6, 5, 4});
                    const SliceStack stack = randomStack(random, frame, random.real(0.0, 0.9));
                    const SliceProblem problem(stack, randomCriterion(random));
                    GreedySelection greedy(problem);
                    RecordingJudge judge(everyLeg());
                    finish(greedy, judge);
                    const auto expected = literalSelection(stack, problem.criterion().neighbourhood);
                    ASSERT_EQ(greedy.best().has_value(), expected.has_value());
                    if (!expected)
                    {
                        ++lost;
                        return;
                    }
                    ++found;
                    const std::vector<Vector3d> points = problem.positions(*greedy.best());
                    ASSERT_EQ(points.size(), expected->size());
                    for (std::size_t i = 0; i < points.size(); ++i)
                        EXPECT_TRUE(points[i].isApprox((*expected)[i], 1e-9)) << "plane " << i;
                });
    EXPECT_GT(found, 50);
    EXPECT_GT(lost, 10);
}

SliceFrame corridor()
{
    const Eigen::AlignedBox3d box(Vector3d(0, 0, 0), Vector3d(5, 4, 4));
    return *SliceFrame::between({0, 2, 2}, {5, 2, 2}, box, {6, 5, 5}, SliceAxis::X);
}

TEST(GreedySelection, TakesTheNextBestWhereALegIsInvalid)
{
    const SliceProblem problem(SliceStack(corridor()), {});
    GreedySelection greedy(problem);
    RecordingJudge judge([](const Vector3d &, const Vector3d &to) { return to != Vector3d(2, 2, 2); });
    finish(greedy, judge);
    ASSERT_TRUE(greedy.best());
    EXPECT_EQ((*greedy.best())[0], (SliceCell{2, 2}));
    EXPECT_EQ((*greedy.best())[1], (SliceCell{1, 2})) << "the first of four that are equally good";
    EXPECT_EQ((*greedy.best())[2], (SliceCell{1, 2})) << "the reference line leads on from there";
}

TEST(GreedySelection, TellsADeadEnd)
{
    SliceStack stack(corridor());
    for (std::size_t i = 0; i < stack.frame().cellCount(); ++i)
        stack.block(3, stack.frame().cell(i));
    const SliceProblem walled(stack, {});
    GreedySelection greedy(walled);
    RecordingJudge judge(everyLeg());
    EXPECT_EQ(greedy.work(judge), SliceSearch::Step::Done);
    EXPECT_EQ(greedy.work(judge), SliceSearch::Step::Done);
    EXPECT_FALSE(greedy.best());
    EXPECT_EQ(greedy.farthestPlane(), 2);
}

TEST(GreedySelection, TheLastLegMustBeValidToo)
{
    const SliceProblem problem(SliceStack(corridor()), {});
    GreedySelection greedy(problem);
    RecordingJudge judge([](const Vector3d &, const Vector3d &to) { return to.x() < 4.5; });
    finish(greedy, judge);
    EXPECT_FALSE(greedy.best());
    EXPECT_EQ(greedy.farthestPlane(), 4);
}

/// A pocket that is open towards the start swallows the greedy selection, though there is a way around it.
TEST(GreedySelection, WalksIntoAPocket)
{
    SliceStack stack(corridor());
    // a long way round is left at the edge, across 0, out of reach of the pocket's legs
    for (int level = 0; level < 5; ++level)
        for (int across = 1; across < 5; ++across)
            stack.block(4, {across, level});
    const SliceProblem problem(stack, {});
    GreedySelection greedy(problem);
    RecordingJudge judge([](const Vector3d &from, const Vector3d &to) { return std::abs(from.y() - to.y()) < 1.5; });
    finish(greedy, judge);
    EXPECT_FALSE(greedy.best());
    EXPECT_EQ(greedy.farthestPlane(), 3);
}

TEST(GreedySelection, InterruptionsChangeNothing)
{
    forEachSeed(60,
                [](Random &random)
                {
                    const SliceStack stack = randomStack(random, randomFrame(random, {6, 4, 4}), 0.4);
                    const SliceProblem problem(stack, randomCriterion(random));
                    const auto legs = randomLegs(random, random.real(0.2, 1.0));
                    GreedySelection atOnce(problem);
                    GreedySelection inPieces(problem);
                    RecordingJudge patient(legs);
                    RecordingJudge hasty(legs, 1);
                    finish(atOnce, patient);
                    EXPECT_GE(finish(inPieces, hasty), static_cast<int>(patient.legs()) - 1);
                    EXPECT_EQ(atOnce.best(), inPieces.best());
                    EXPECT_EQ(atOnce.farthestPlane(), inPieces.farthestPlane());
                    if (atOnce.best())
                        expectUsable(problem, *atOnce.best(), legs);
                    EXPECT_LE(hasty.mostRepeats(), 1);
                });
}

}  // namespace
}  // namespace seahex::test
