#pragma once

#include <seahex/geometry/CellLayout.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace seahex
{

/// The bits of all cells up to three rows and columns away from one, as a single number: seven rows of seven bits. What
/// three rings reach or touch lies within, so that "are all these cells free?" is one AND.
///
/// Bit 8 (row + 3) + column + 3 is the cell so many rows south and columns east of the middle; the others are 0. Which
/// of them are neighbours depends on the parity of the middle's row (HexCoord.h).
class HexWindow
{
public:
    static constexpr std::int64_t reach = 3;

    static constexpr bool contains(OffsetCoord difference)
    {
        return difference.column >= -reach && difference.column <= reach && difference.row >= -reach &&
               difference.row <= reach;
    }

    /// @param difference  within `reach`
    static constexpr std::uint64_t bit(OffsetCoord difference)
    {
        return std::uint64_t{1} << (8 * (difference.row + reach) + difference.column + reach);
    }

    /// @param words  one bit a cell in the order of the layout
    explicit HexWindow(const CellLayout &layout, const std::uint64_t *words)
        : bytes_(reinterpret_cast<const unsigned char *>(words)), rowBytes_(layout.stride() / 8)
    {
    }

    /// The window around a cell of the layout's rectangle.
    [[gnu::always_inline]] std::uint64_t around(CellIndex cell) const
    {
        // a stride is whole words, so the bits begin at the same place in the first byte of each row
        const CellIndex first = cell - static_cast<CellIndex>(reach);
        const unsigned char *row = bytes_ + (first >> 3) - reach * rowBytes_;
        const auto next = [this, &row]
        {
            std::uint16_t pair;
            std::memcpy(&pair, row, sizeof pair);
            row += rowBytes_;
            return pair;
        };
        Rows rows = {next(), next(), next(), next(), next(), next(), next(), 0};  // braces: from left to right
        rows = (rows >> static_cast<std::uint16_t>(first & 7)) & std::uint16_t{0x7F};
        const auto narrow = __builtin_convertvector(rows, Bytes);
        std::uint64_t window;
        std::memcpy(&window, &narrow, sizeof window);
        return window;
    }

private:
    // vectors of 128 and 64 bits, which every x86-64 and arm64 has
    typedef std::uint16_t Rows __attribute__((vector_size(16)));
    typedef std::uint8_t Bytes __attribute__((vector_size(8)));
    static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "bytes of a word are read in the order of its bits");

    const unsigned char *bytes_;
    std::ptrdiff_t rowBytes_;
};

}  // namespace seahex
