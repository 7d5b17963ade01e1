#pragma once

#include <seahex/geometry/CellLayout.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace seahex
{

/// One bit for every index of a layout, written span by span.
class CellBits
{
public:
    explicit CellBits(const CellLayout &layout) : layout_(layout), words_(layout.wordCount(), 0) {}

    const CellLayout &layout() const { return layout_; }
    const std::vector<std::uint64_t> &words() const { return words_; }
    std::vector<std::uint64_t> &words() { return words_; }

    /// Sets the bits of a span of columns of one row; what lies outside the rectangle is cut off.
    void setSpan(std::int64_t row, std::int64_t firstColumn, std::int64_t lastColumn)
    {
        firstColumn = std::max<std::int64_t>(firstColumn, 0);
        lastColumn = std::min(lastColumn, layout_.columns() - 1);
        if (row < 0 || row >= layout_.rows() || firstColumn > lastColumn)
            return;
        setIndices(layout_.index(OffsetCoord{firstColumn, row}), layout_.index(OffsetCoord{lastColumn, row}));
    }

    /// Sets every bit that belongs to no cell of the rectangle: frame and padding.
    void setOutside();

private:
    void setIndices(std::size_t first, std::size_t last)
    {
        const std::uint64_t head = ~std::uint64_t{0} << (first & 63);
        const std::uint64_t tail = ~std::uint64_t{0} >> (63 - (last & 63));
        const std::size_t firstWord = first >> 6;
        const std::size_t lastWord = last >> 6;
        if (firstWord == lastWord)
        {
            words_[firstWord] |= head & tail;
            return;
        }
        words_[firstWord] |= head;
        std::fill(words_.begin() + static_cast<std::ptrdiff_t>(firstWord) + 1,
                  words_.begin() + static_cast<std::ptrdiff_t>(lastWord), ~std::uint64_t{0});
        words_[lastWord] |= tail;
    }

    CellLayout layout_;
    std::vector<std::uint64_t> words_;
};

}  // namespace seahex
