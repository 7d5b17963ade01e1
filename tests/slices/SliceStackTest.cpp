#include "slices/SliceWorlds.h"

#include <seahex/slices/SliceProblem.h>

#include <gtest/gtest.h>

#include <string>

namespace seahex::test
{
namespace
{

const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 5, 4));

/// Three planes of 6 x 5 points, spaced as the integers; the middle one is drawn, '#' blocked, the highest level first.
SliceStack drawn(const std::vector<std::string> &rows)
{
    SliceStack stack(*SliceFrame::between({0, 2, 2}, {4, 2, 2}, box, {3, 6, 5}, SliceAxis::X));
    for (int row = 0; row < 5; ++row)
        for (int across = 0; across < 6; ++across)
            if (rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(across)] == '#')
                stack.block(1, {across, 4 - row});
    return stack;
}

std::vector<std::string> drawing(const SliceStack &stack)
{
    std::vector<std::string> rows;
    for (int level = 4; level >= 0; --level)
    {
        std::string &row = rows.emplace_back();
        for (int across = 0; across < 6; ++across)
            row += stack.isBlocked(1, {across, level}) ? '#' : '.';
    }
    return rows;
}

TEST(SliceStack, InflatesByALevel)
{
    SliceStack stack = drawn({"......", "..#...", "......", "#.....", "##...#"});
    stack.inflate();
    EXPECT_EQ(drawing(stack), (std::vector<std::string>{"..#...", "..#...", "#.#...", "##...#", "##...#"}));
    EXPECT_FALSE(stack.isBlocked(0, {2, 2})) << "another plane";
}

/// The seabed's height taken as its integer part plus one: a point is blocked up to and including that.
TEST(SliceStack, InflationIsTheIntegerPartPlusOne)
{
    for (const double height : {-0.5, 0.0, 0.3, 0.99, 1.0, 1.7, 2.5, 3.0})
    {
        SliceStack stack = drawn(std::vector<std::string>(5, "......"));
        for (int level = 0; level < 5; ++level)
            if (level <= height)
                stack.block(1, {3, level});
        stack.inflate();
        for (int level = 0; level < 5; ++level)
            EXPECT_EQ(stack.isBlocked(1, {3, level}), level <= std::floor(height) + 1.0 && height >= 0.0)
                << height << ", level " << level;
    }
}

TEST(SliceStack, CountsBlockedNeighbours)
{
    const SliceStack stack = drawn({"......", ".###..", ".#.#..", ".###.#", "......"});
    EXPECT_EQ(stack.danger(1, {2, 2}, 3), 1.0);
    EXPECT_EQ(stack.danger(1, {4, 2}, 3), 4.0 / 8.0);
    EXPECT_EQ(stack.danger(1, {3, 2}, 3), 4.0 / 8.0) << "the point itself does not count";
    EXPECT_EQ(stack.danger(1, {2, 2}, 5), 8.0 / 24.0);
    EXPECT_EQ(stack.danger(1, {0, 4}, 3), 6.0 / 8.0) << "five beyond the grid";
    EXPECT_EQ(stack.danger(0, {2, 2}, 3), 0.0) << "another plane";
}

TEST(SliceStack, PlacesLieInTheCellsOfTheNearestPoints)
{
    const SliceStack stack = drawn({"......", "......", "..#...", "......", "......"});
    const auto isFree = [&](double y, double z)
    {
        return stack.isFreeAt(1, {2.0, y, z});
    };
    EXPECT_FALSE(isFree(2.0, 2.0));
    EXPECT_FALSE(isFree(2.49, 1.6));
    EXPECT_FALSE(isFree(2.5, 2.5)) << "halfway belongs to both";
    EXPECT_FALSE(isFree(1.5, 2.0));
    EXPECT_TRUE(isFree(2.51, 2.0));
    EXPECT_TRUE(isFree(2.0, 1.49));
    EXPECT_TRUE(isFree(0.0, 0.0));
    EXPECT_TRUE(isFree(-0.49, 4.49));
    EXPECT_FALSE(isFree(-0.5, 2.0)) << "beyond the grid";
    EXPECT_FALSE(isFree(2.0, 4.6));
}

TEST(SliceProblem, PointsWithoutAFreeNeighbourAreNotOpen)
{
    const SliceProblem problem(drawn({"......", ".###..", ".#.#..", ".###..", "......"}), {});
    const auto isOpen = [&](SliceCell cell)
    {
        return problem.isOpen(1, problem.frame().index(cell));
    };
    EXPECT_FALSE(isOpen({2, 2}));
    EXPECT_FALSE(isOpen({1, 2}));
    EXPECT_TRUE(isOpen({0, 2}));
}

TEST(SliceProblem, FiguresAreThoseOfThePaper)
{
    const SliceCriterion criterion{0.25, 2.0, 3};
    const SliceProblem problem(drawn({"......", ".###..", ".#.#..", ".###..", "......"}), criterion);
    const SliceFigures figures = problem.figures({{4, 2}});
    const double length = 2.0 * std::sqrt(4.0 + 4.0) / 2.0;
    EXPECT_DOUBLE_EQ(figures.length, length);
    EXPECT_DOUBLE_EQ(figures.danger, 3.0 / 8.0);
    EXPECT_DOUBLE_EQ(figures.total, 0.25 * length + 0.75 * 3.0 / 8.0);
    const SliceFigures straight = problem.figures({{4, 2}}, {0, 2});
    EXPECT_DOUBLE_EQ(straight.length, 2.0);
    EXPECT_EQ(straight.danger, 0.0);
}

}  // namespace
}  // namespace seahex::test
