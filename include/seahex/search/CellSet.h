#pragma once

#include <seahex/geometry/CellLayout.h>
#include <seahex/geometry/HexWindow.h>

#include <cstdint>
#include <vector>

namespace seahex
{

/// Cells of a layout, each once, 64 at a time; clearing takes time by what was added.
class CellSet
{
public:
    explicit CellSet(const CellLayout &layout)
        : words_(layout.wordCount(), 0), rowWords_(static_cast<std::size_t>(layout.stride() / 64))
    {
    }

    void add(CellIndex cell) { add(cell >> 6, std::uint64_t{1} << (cell & 63)); }
    /// @param bits  of the word's 64 cells
    void add(std::size_t word, std::uint64_t bits)
    {
        if (words_[word] == 0 && bits != 0)
            listed_.push_back(static_cast<std::uint32_t>(word));
        words_[word] |= bits;
    }

    /// These cells of the rectangle, and all up to three rows and columns away: those whose HexWindow holds one of
    /// them. Cells of the frame, and padding, may be among them.
    void addAround(std::size_t word, std::uint64_t bits)
    {
        constexpr auto reach = static_cast<std::size_t>(HexWindow::reach);
        const std::uint64_t here = bits | bits << 1 | bits << 2 | bits << 3 | bits >> 1 | bits >> 2 | bits >> 3;
        const std::uint64_t before = bits << 63 | bits << 62 | bits << 61;
        const std::uint64_t behind = bits >> 63 | bits >> 62 | bits >> 61;
        for (std::size_t w = word - reach * rowWords_; w <= word + reach * rowWords_; w += rowWords_)
        {
            add(w, here);
            if (before != 0)
                add(w - 1, before);
            if (behind != 0)
                add(w + 1, behind);
        }
    }

    /// Calls visit(word, bits) for every word that holds cells.
    template <class Visit>
    void forEachWord(Visit &&visit) const
    {
        for (const std::uint32_t word : listed_)
            visit(static_cast<std::size_t>(word), words_[word]);
    }

    /// Calls visit(cell) for every cell.
    template <class Visit>
    void forEach(Visit &&visit) const
    {
        forEachWord(
            [&visit](std::size_t word, std::uint64_t bits)
            {
                for (; bits != 0; bits &= bits - 1)
                    visit(static_cast<CellIndex>(64 * word) + static_cast<CellIndex>(__builtin_ctzll(bits)));
            });
    }

    bool empty() const { return listed_.empty(); }

    void clear()
    {
        for (const std::uint32_t word : listed_)
            words_[word] = 0;
        listed_.clear();
    }

private:
    std::vector<std::uint64_t> words_;
    std::size_t rowWords_;
    std::vector<std::uint32_t> listed_;
};

}  // namespace seahex
