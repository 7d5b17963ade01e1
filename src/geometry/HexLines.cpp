#include "seahex/geometry/HexLines.h"

#include <algorithm>
#include <cstdlib>

namespace seahex
{

HexLines HexLines::across(HexCoord start, HexCoord goal)
{
    const HexCoord difference = start - goal;
    const std::int64_t rows = std::abs(difference.s);
    const std::int64_t q = std::abs(difference.q);
    const std::int64_t r = std::abs(difference.r());
    if (rows >= q && rows >= r)
        return {Direction::Rows, goal};
    return {q >= r ? Direction::EqualQ : Direction::EqualR, goal};
}

HexLines::Place HexLines::placeOf(HexCoord cell) const
{
    const HexCoord d = cell - origin_;
    switch (direction_)
    {
        case Direction::Rows:
            return {d.s, d.q};
        case Direction::EqualQ:
            return {d.q, d.s};
        case Direction::EqualR:
            break;
    }
    return {d.r(), d.s};
}

HexCoord HexLines::cellAt(Place at) const
{
    switch (direction_)
    {
        case Direction::Rows:
            return origin_ + HexCoord{at.place, at.line};
        case Direction::EqualQ:
            return origin_ + HexCoord{at.line, at.place};
        case Direction::EqualR:
            break;
    }
    return origin_ + HexCoord{-at.line - at.place, at.place};
}

std::pair<std::int64_t, std::int64_t> HexLines::extent(std::int64_t line, const CellLayout &layout) const
{
    const std::int64_t columns = layout.columns();
    const std::int64_t rows = layout.rows();
    if (direction_ == Direction::Rows)
    {
        const std::int64_t row = origin_.s + line;
        if (row < 0 || row >= rows)
            return {0, -1};
        const std::int64_t first = toCube({0, row}).q - origin_.q;
        return {first, first + columns - 1};
    }
    // the rows s in which the column, q + ceil(s / 2) = -r - floor(s / 2), lies in the rectangle
    std::int64_t first = 0;
    std::int64_t last = 0;
    if (direction_ == Direction::EqualQ)
    {
        const std::int64_t q = origin_.q + line;
        first = -2 * q - 1;
        last = 2 * (columns - 1 - q);
    }
    else
    {
        const std::int64_t r = origin_.r() + line;
        first = 2 * (1 - columns - r);
        last = 1 - 2 * r;
    }
    return {std::max<std::int64_t>(first, 0) - origin_.s, std::min(last, rows - 1) - origin_.s};
}

}  // namespace seahex
