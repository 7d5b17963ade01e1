#include <seahex/geometry/SquareTraversal.h>

#include "support/SquareOracle.h"
#include "support/TouchedCells.h"

#include <vector>

#include <boost/geometry.hpp>
#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace bg = boost::geometry;

TEST(SquareTraversal, edgesAndCornersCount)
{
    // A diagonal step runs through a corner: the cells on either side of it are touched.
    EXPECT_EQ(touchedCells<OffsetCoord>({0, 0}, {1, 1}), (std::vector<OffsetCoord>{{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
    // Level and upright nothing else is touched, for neighbours meet in edges.
    EXPECT_EQ(touchedCells<OffsetCoord>({0, 0}, {3, 0}), (std::vector<OffsetCoord>{{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
    EXPECT_EQ(touchedCells<OffsetCoord>({-1, 2}, {-1, 0}), (std::vector<OffsetCoord>{{-1, 0}, {-1, 1}, {-1, 2}}));
    // The knight's move crosses the edge between the two cells it passes.
    EXPECT_EQ(touchedCells<OffsetCoord>({0, 0}, {1, 2}), (std::vector<OffsetCoord>{{0, 0}, {0, 1}, {1, 1}, {1, 2}}));
    EXPECT_EQ(touchedCells<OffsetCoord>({7, -3}, {7, -3}), (std::vector<OffsetCoord>{{7, -3}}));
}

TEST(SquareTraversal, boostSeesTheSame)
{
    // in doubles that hold these small halves exactly
    using Plane = bg::model::d2::point_xy<double>;
    for (std::int64_t columns = -7; columns <= 7; ++columns)
        for (std::int64_t rows = -7; rows <= 7; ++rows)
        {
            const bg::model::segment<Plane> segment({0.0, 0.0},
                                                    {static_cast<double>(2 * columns), static_cast<double>(2 * rows)});
            std::vector<OffsetCoord> expected;
            for (std::int64_t row = -8; row <= 8; ++row)
                for (std::int64_t column = -8; column <= 8; ++column)
                {
                    const auto x = static_cast<double>(2 * column);
                    const auto y = static_cast<double>(2 * row);
                    const bg::model::box<Plane> cell({x - 1.0, y - 1.0}, {x + 1.0, y + 1.0});
                    if (bg::intersects(segment, cell))
                        expected.push_back({column, row});
                }
            ASSERT_EQ(touchedCells<OffsetCoord>({0, 0}, {columns, rows}), expected) << columns << ", " << rows;
        }
}
