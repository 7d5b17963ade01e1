#include "slices/SliceWorlds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seahex::test
{
namespace
{

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

const AlignedBox3d cube(Vector3d(1, 1, 1), Vector3d(25, 25, 25));

TEST(SliceFrame, GridOfThePaperIsThatOfTheIntegers)
{
    const auto frame = SliceFrame::between({1, 8, 6}, {25, 23, 10}, cube, {25, 25, 25}, SliceAxis::X);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->spacing(), 1.0);
    EXPECT_EQ(frame->acrossStep(), 1.0);
    EXPECT_EQ(frame->levelStep(), 1.0);
    for (int plane = 0; plane < 25; ++plane)
        for (std::size_t i = 0; i < frame->cellCount(); ++i)
        {
            const SliceCell cell = frame->cell(i);
            EXPECT_EQ(frame->index(cell), i);
            EXPECT_EQ(frame->position(plane, cell), Vector3d(plane + 1, cell.across + 1, cell.level + 1));
        }
}

TEST(SliceFrame, TurnsWithTheGoal)
{
    const auto west = SliceFrame::between({25, 23, 10}, {1, 8, 6}, cube, {25, 25, 25}, SliceAxis::X);
    ASSERT_TRUE(west);
    EXPECT_EQ(west->spacing(), 1.0);
    EXPECT_EQ(west->position(0, {0, 0}).x(), 25.0);
    EXPECT_EQ(west->position(24, {0, 0}).x(), 1.0);
    const auto south = SliceFrame::between({25, 23, 10}, {1, 8, 6}, cube, {16, 25, 25}, SliceAxis::Y);
    ASSERT_TRUE(south);
    EXPECT_EQ(south->spacing(), 1.0);
    EXPECT_EQ(south->position(1, {7, 3}).y(), 22.0);
}

TEST(SliceFrame, NeedsRoomAlongItsAxis)
{
    EXPECT_FALSE(SliceFrame::between({5, 5, 2}, {5, 5, 20}, cube, {}, SliceAxis::Course));
    EXPECT_FALSE(SliceFrame::between({5, 5, 2}, {5, 5, 2}, cube, {}, SliceAxis::Course));
    EXPECT_FALSE(SliceFrame::between({5, 5, 2}, {5, 9, 2}, cube, {}, SliceAxis::X));
    EXPECT_FALSE(SliceFrame::between({5, 5, 2}, {9, 5, 2}, cube, {}, SliceAxis::Y));
    EXPECT_TRUE(SliceFrame::between({5, 5, 2}, {5, 9, 2}, cube, {}, SliceAxis::Y));
}

TEST(SliceFrame, PlanesStandAcrossTheAxisAtEqualDistances)
{
    forEachSeed(100,
                [](Random &random)
                {
                    const SliceFrame frame = randomFrame(random, {7, 4, 5});
                    const Vector3d up = frame.position(0, {0, 1}) - frame.position(0, {0, 0});
                    const Vector3d aside = frame.position(0, {1, 0}) - frame.position(0, {0, 0});
                    const Vector3d ahead = frame.position(1, {0, 0}) - frame.position(0, {0, 0});
                    EXPECT_NEAR(ahead.norm(), frame.spacing(), 1e-9);
                    EXPECT_NEAR(aside.norm(), frame.acrossStep(), 1e-9);
                    EXPECT_NEAR(up.norm(), frame.levelStep(), 1e-9);
                    EXPECT_NEAR(ahead.dot(aside), 0.0, 1e-9);
                    EXPECT_EQ(ahead.z(), 0.0);
                    EXPECT_EQ(aside.z(), 0.0);
                    EXPECT_NEAR((frame.start() - frame.position(0, {0, 0})).dot(ahead), 0.0, 1e-9);
                    EXPECT_NEAR((frame.goal() - frame.position(6, {0, 0})).dot(ahead), 0.0, 1e-9);
                });
}

TEST(SliceFrame, CourseLeadsFromStartToGoal)
{
    const auto frame = SliceFrame::between({2, 3, 4}, {14, 19, 20}, cube, {5, 3, 3}, SliceAxis::Course);
    ASSERT_TRUE(frame);
    EXPECT_DOUBLE_EQ(frame->spacing(), 5.0);
    const Vector3d ahead = frame->position(1, {1, 1}) - frame->position(0, {1, 1});
    EXPECT_TRUE(ahead.isApprox(Vector3d(3, 4, 0)));
}

TEST(SliceFrame, CrossingsLieOnLineAndPlane)
{
    forEachSeed(100,
                [](Random &random)
                {
                    const SliceFrame frame = randomFrame(random, {6, 4, 5});
                    const Vector3d a = frame.position(0, {0, 1});
                    const Vector3d b = frame.position(5, {3, 4});
                    for (int plane = 0; plane < 6; ++plane)
                    {
                        const Vector3d p = frame.crossing(plane, a, b);
                        EXPECT_TRUE(p.isApprox(a + plane / 5.0 * (b - a), 1e-9)) << plane;
                    }
                });
}

/// Whatever a plane has in common with the box lies on its grid, and no finer grid is wasted on more than that.
TEST(SliceFrame, GridSpansTheBox)
{
    forEachSeed(100,
                [](Random &random)
                {
                    const Vector3d corner(random.real(5.0, 30.0), random.real(5.0, 30.0), random.real(1.0, 9.0));
                    const AlignedBox3d bounds(Vector3d::Zero(), corner);
                    const auto place = [&]
                    {
                        return Vector3d(random.unit() * corner.x(), random.unit() * corner.y(), 0.5);
                    };
                    const Vector3d start = place();
                    const Vector3d goal = place();
                    const auto frame = SliceFrame::between(start, goal, bounds, {5, 8, 4}, SliceAxis::Course);
                    ASSERT_TRUE(frame);
                    double least = 100.0;
                    double most = -100.0;
                    for (int plane = 0; plane < 5; ++plane)
                        for (int i = 0; i <= 20000; ++i)
                        {
                            const Vector3d side = frame->position(plane, {1, 0}) - frame->position(plane, {0, 0});
                            const double steps = -50.0 + 0.005 * i;
                            const Vector3d p = frame->position(plane, {0, 0}) + steps * side;
                            if (!bounds.contains(p))
                                continue;
                            least = std::min(least, steps);
                            most = std::max(most, steps);
                        }
                    EXPECT_NEAR(least, 0.0, 0.01);
                    EXPECT_NEAR(most, 7.0, 0.01);
                });
}

TEST(SliceFrame, GridCoordinatesAreThoseOfTheCells)
{
    forEachSeed(50,
                [](Random &random)
                {
                    const SliceFrame frame = randomFrame(random, {4, 5, 6});
                    for (int plane = 0; plane < 4; ++plane)
                        for (std::size_t i = 0; i < frame.cellCount(); ++i)
                        {
                            const SliceCell cell = frame.cell(i);
                            const Eigen::Vector2d at = frame.gridCoordinates(frame.position(plane, cell));
                            EXPECT_NEAR(at.x(), cell.across, 1e-9);
                            EXPECT_NEAR(at.y(), cell.level, 1e-9);
                        }
                });
}

}  // namespace
}  // namespace seahex::test
