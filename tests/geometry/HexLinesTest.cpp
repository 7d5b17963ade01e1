#include <seahex/geometry/HexLines.h>

#include "support/Random.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

HexCoord randomCell(Random &random)
{
    return {random.integer(-20, 20), random.integer(-20, 20)};
}

}  // namespace

TEST(HexLines, neighboursHaveTheSamePlacesInEveryDirection)
{
    forEachSeed(
        300,
        [](Random &random)
        {
            const HexCoord goal = randomCell(random);
            const HexLines lines = HexLines::across(randomCell(random), goal);
            ASSERT_EQ(lines.origin(), goal);
            ASSERT_EQ(lines.cellAt({0, 0}), goal);
            const HexCoord cell = randomCell(random);
            const HexLines::Place at = lines.placeOf(cell);
            ASSERT_EQ(lines.cellAt(at), cell);
            for (const HexLines::Place &step : {HexLines::Place{0, 1}, {0, -1}, {-1, 0}, {-1, 1}, {1, 0}, {1, -1}})
                ASSERT_EQ(hexDistance(cell, lines.cellAt({at.line + step.line, at.place + step.place})), 1);
        });
}

TEST(HexLines, asManyLinesAsCanBeLieAcross)
{
    forEachSeed(300,
                [](Random &random)
                {
                    const HexCoord start = randomCell(random);
                    const HexCoord goal = randomCell(random);
                    // the largest of |q|, |r| and |s| is the number of steps
                    ASSERT_EQ(std::abs(HexLines::across(start, goal).placeOf(start).line), hexDistance(start, goal));
                });
}

TEST(HexLines, extentsAndWalksAreThoseOfTheRectangle)
{
    forEachSeed(300,
                [](Random &random)
                {
                    const CellLayout layout(random.integer(1, 9), random.integer(1, 9));
                    const auto cell = [&]
                    {
                        return toCube({random.integer(0, layout.columns() - 1), random.integer(0, layout.rows() - 1)});
                    };
                    const HexLines lines = HexLines::across(randomCell(random), cell());
                    std::map<std::int64_t, std::map<std::int64_t, CellIndex>> expected;  // by line and place
                    for (std::int64_t row = 0; row < layout.rows(); ++row)
                        for (std::int64_t column = 0; column < layout.columns(); ++column)
                        {
                            const HexLines::Place at = lines.placeOf(toCube({column, row}));
                            expected[at.line][at.place] = layout.index(OffsetCoord{column, row});
                        }
                    for (std::int64_t line = -30; line <= 30; ++line)
                    {
                        const auto [first, last] = lines.extent(line, layout);
                        const auto &cells = expected[line];
                        ASSERT_EQ(static_cast<std::size_t>(std::max<std::int64_t>(last - first + 1, 0)), cells.size());
                        if (cells.empty())
                            continue;
                        ASSERT_EQ(first, cells.begin()->first);
                        ASSERT_EQ(last, cells.rbegin()->first);
                        std::vector<CellIndex> forwards;
                        std::vector<CellIndex> walked;
                        for (const auto &[place, index] : cells)
                            forwards.push_back(index);
                        lines.forEachCell(line, first, last, layout, [&](CellIndex i) { walked.push_back(i); });
                        ASSERT_EQ(walked, forwards);
                        walked.clear();
                        lines.forEachCell(line, last, first, layout, [&](CellIndex i) { walked.push_back(i); });
                        std::reverse(walked.begin(), walked.end());
                        ASSERT_EQ(walked, forwards);
                    }
                });
}
