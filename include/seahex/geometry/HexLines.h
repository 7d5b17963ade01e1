#pragma once

#include <seahex/geometry/CellLayout.h>
#include <seahex/geometry/HexCoord.h>

#include <cstdint>
#include <cstdlib>
#include <utility>

namespace seahex
{

/// The parallel lines of neighbouring cells in one of the three directions of a hexagonal lattice: its rows, or one of
/// the two diagonals.
///
/// A cell is addressed by its line and its place on the line, both relative to an origin cell and counted such that the
/// neighbours of (line, place) on the line before are (line - 1, place) and (line - 1, place + 1). The same holds with
/// both signs turned, so each side of the origin's line looks like the other.
class HexLines
{
public:
    struct Place
    {
        std::int64_t line;
        std::int64_t place;
    };

    /// The direction in which most lines lie between the two cells; rows, then the lines of equal q, where several do.
    /// @param goal  the origin
    static HexLines across(HexCoord start, HexCoord goal);

    HexCoord origin() const { return origin_; }

    Place placeOf(HexCoord cell) const;

    /// The places of a line that lie in the rectangle of a layout, first and last; the first is the greater if there
    /// are none.
    std::pair<std::int64_t, std::int64_t> extent(std::int64_t line, const CellLayout &layout) const;

    /// Calls visit(index) for the cells of a line from place `from` to place `to`, in that order, backwards if `to` is
    /// the smaller. Both must lie in the rectangle.
    template <class Visit>
    void forEachCell(std::int64_t line, std::int64_t from, std::int64_t to, const CellLayout &layout,
                     Visit &&visit) const
    {
        const std::int64_t way = from <= to ? 1 : -1;
        const OffsetCoord begin = toOffset(cellAt({line, from}));
        // along a diagonal it is one row on and half a cell aside: a column more, or less, after every second row
        std::int64_t onFromEven = direction_ == Direction::Rows ? 1 : layout.stride();
        std::int64_t onFromOdd = onFromEven;
        if (direction_ == Direction::EqualQ)
            ++onFromEven;
        else if (direction_ == Direction::EqualR)
            --onFromOdd;
        const bool alternates = direction_ != Direction::Rows;
        bool isEven = (begin.row % 2 == 0) == (way > 0);  // of the row farther north, of this cell and the next
        std::int64_t index = layout.index(begin);
        for (std::int64_t count = std::abs(to - from) + 1; count > 0; --count)
        {
            visit(static_cast<CellIndex>(index));
            index += way * (isEven ? onFromEven : onFromOdd);
            isEven = isEven != alternates;
        }
    }

    HexCoord cellAt(Place at) const;

private:
    enum class Direction
    {
        Rows,    // equal s, places along q
        EqualQ,  // places along s
        EqualR   // places along s
    };

    HexLines(Direction direction, HexCoord origin) : direction_(direction), origin_(origin) {}

    Direction direction_;
    HexCoord origin_;
};

}  // namespace seahex
