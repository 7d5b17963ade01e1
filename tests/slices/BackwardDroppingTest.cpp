#include "slices/SliceWorlds.h"

#include <seahex/slices/BackwardDropping.h>
#include <seahex/slices/ExactSelection.h>

#include <gtest/gtest.h>

namespace seahex::test
{
namespace
{

using Eigen::Vector3d;

/// [Xu] as it is written: from the goal, points are tried in reverse; each segment's crossings with all planes between
/// must be free, here by the nearest grid points to them, found one by one.
std::vector<int> literalOptimisation(const SliceProblem &problem, const std::vector<Vector3d> &points,
                                     const RecordingJudge::Rule &isValid)
{
    const SliceFrame &frame = problem.frame();
    const auto isFree = [&](int plane, const Vector3d &p)
    {
        const double across = frame.acrossStep();
        const double up = frame.levelStep();
        const Vector3d origin = frame.position(plane, {0, 0});
        const Vector3d aside = (frame.position(plane, {1, 0}) - origin) / across;
        for (int a = -1; a <= frame.across(); ++a)
            for (int b = -1; b <= frame.levels(); ++b)
            {
                const double da = std::abs((p - origin).dot(aside) - a * across);
                const double db = std::abs(p.z() - origin.z() - b * up);
                const bool isNear = da <= (0.5 + 1e-9) * across && db <= (0.5 + 1e-9) * up;
                if (isNear && problem.stack().isBlocked(plane, {a, b}))
                    return false;
            }
        return true;
    };
    const auto sees = [&](std::size_t from, std::size_t to)
    {
        for (std::size_t i = from + 1; i < to; ++i)
        {
            const double t = static_cast<double>(i - from) / static_cast<double>(to - from);
            if (!isFree(static_cast<int>(i), points[from] + t * (points[to] - points[from])))
                return false;
        }
        return isValid(points[from], points[to]);
    };
    std::vector<int> kept = {frame.planes() - 1};
    std::size_t base = points.size() - 1;
    while (base > 0)
    {
        std::size_t end = base - 1;
        while (end > 0 && sees(end - 1, base))
            --end;
        kept.insert(kept.begin(), static_cast<int>(end));
        base = end;
    }
    return kept;
}

TEST(BackwardDropping, DropsAsPublished)
{
    int dropped = 0;
    int kept = 0;
    forEachSeed(150,
                [&](Random &random)
                {
                    const SliceStack stack = randomStack(random, randomFrame(random, {8, 6, 5}), random.real(0.0, 0.4));
                    const SliceProblem problem(stack, randomCriterion(random));
                    const auto legs = random.chance(0.3) ? everyLeg() : randomLegs(random, random.real(0.4, 1.0));
                    ExactSelection exact(problem);
                    RecordingJudge searching(legs);
                    finish(exact, searching);
                    if (!exact.best())
                        return;
                    BackwardDropping dropping(problem, *exact.best());
                    RecordingJudge judge(legs, 1);
                    while (!dropping.work(judge))
                        judge.resume();
                    const std::vector<int> planes = dropping.planes();
                    EXPECT_EQ(planes, literalOptimisation(problem, problem.positions(*exact.best()), legs));
                    EXPECT_LE(judge.legs(), 6u);
                    EXPECT_LE(judge.mostRepeats(), 1);
                    dropped += planes.size() < 8 ? 1 : 0;
                    kept += planes.size() > 2 ? 1 : 0;

                    const SliceFigures before = problem.figures(*exact.best());
                    const SliceFigures after = problem.figures(*exact.best(), planes);
                    EXPECT_LE(after.length, before.length + 1e-9);
                    EXPECT_LE(after.danger, before.danger + 1e-9);
                });
    EXPECT_GT(dropped, 40);
    EXPECT_GT(kept, 40);
}

TEST(BackwardDropping, LeavesTheStraightLineOfAFreeSpace)
{
    Random random(1);
    const SliceProblem problem(SliceStack(randomFrame(random, {6, 5, 5})), {});
    BackwardDropping dropping(problem, SlicePath(4, SliceCell{1, 2}));
    RecordingJudge judge(everyLeg());
    EXPECT_TRUE(dropping.work(judge));
    EXPECT_EQ(dropping.planes(), (std::vector<int>{0, 5}));
}

TEST(BackwardDropping, KeepsTwoPlanesAsTheyAre)
{
    Random random(1);
    const SliceProblem problem(SliceStack(randomFrame(random, {2, 5, 5})), {});
    BackwardDropping dropping(problem, {});
    RecordingJudge judge(everyLeg());
    EXPECT_TRUE(dropping.work(judge));
    EXPECT_EQ(dropping.planes(), (std::vector<int>{0, 1}));
    EXPECT_EQ(judge.legs(), 0u);
}

}  // namespace
}  // namespace seahex::test
