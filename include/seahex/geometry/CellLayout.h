#pragma once

#include <seahex/geometry/HexCoord.h>

#include <cstddef>
#include <cstdint>

namespace seahex
{

/// Position of a cell in flat storage.
using CellIndex = std::uint32_t;

/// The order in which the cells of a rectangle are stored, decided here and nowhere else.
///
/// Row by row, each row padded to whole 64-bit words by `spare` cells or more; around the rectangle runs a frame of
/// `frame` cells, so that every cell a ring jump can reach or touch from inside has an index.
class CellLayout
{
public:
    /// A jump of ring 3 reaches 3 rows and 3 columns away and touches nothing beyond.
    static constexpr std::int64_t frame = 3;
    /// Cells behind each row, at least: whoever reads a cell's surroundings in bytes may read one too many.
    static constexpr std::int64_t spare = 8;

    /// @throws std::length_error if the cells do not fit 32-bit indices
    CellLayout(std::int64_t columns, std::int64_t rows);

    CellIndex index(OffsetCoord cell) const
    {
        return static_cast<CellIndex>((cell.row + frame) * stride_ + cell.column + frame);
    }
    CellIndex index(HexCoord cell) const { return index(toOffset(cell)); }

    OffsetCoord offset(CellIndex index) const
    {
        const auto stride = static_cast<CellIndex>(stride_);  // 32 bits divide faster than 64
        return {static_cast<std::int64_t>(index % stride) - frame, static_cast<std::int64_t>(index / stride) - frame};
    }
    HexCoord cell(CellIndex index) const { return toCube(offset(index)); }

    std::int64_t columns() const { return columns_; }
    std::int64_t rows() const { return rows_; }
    /// Cells from one row to the next; a multiple of 64.
    std::int64_t stride() const { return stride_; }
    /// Number of indices, frame and padding included; a multiple of 64.
    std::size_t size() const { return static_cast<std::size_t>(stride_ * (rows_ + 2 * frame)); }
    std::size_t wordCount() const { return size() / 64; }

private:
    std::int64_t columns_;
    std::int64_t rows_;
    std::int64_t stride_;
};

}  // namespace seahex
