#include <seahex/geometry/HexTraversal.h>

#include "support/TouchedCells.h"

#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

TEST(HexTraversal, edgesAndCornersCount)
{
    // To the cell two rows due south: along the edge that two cells of the row between share.
    EXPECT_EQ(touchedCells<HexCoord>({0, 0}, {-1, 2}), (std::vector<HexCoord>{{0, 0}, {-1, 1}, {0, 1}, {-1, 2}}));
    // Due east nothing else is touched, for level neighbours meet in edges.
    EXPECT_EQ(touchedCells<HexCoord>({0, 0}, {3, 0}), (std::vector<HexCoord>{{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
    // The jump of the third ring passes two cells besides its ends.
    EXPECT_EQ(touchedCells<HexCoord>({0, 0}, {2, 1}), (std::vector<HexCoord>{{0, 0}, {1, 0}, {1, 1}, {2, 1}}));
    EXPECT_EQ(touchedCells<HexCoord>({7, -3}, {7, -3}), (std::vector<HexCoord>{{7, -3}}));
}
