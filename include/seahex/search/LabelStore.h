#pragma once

#include <seahex/geometry/CellLayout.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

namespace seahex
{

/// What a search knows about cells: whether one was reached, whether it was expanded, and a label.
///
/// Pages of memory that no search has touched stay with the system: 2 bits are set aside for an untouched cell, a label
/// and the bits for a touched one, and half a byte or less to find it again. clear() takes time by what was touched.
template <class Label>
class LabelStoreOf
{
public:
    explicit LabelStoreOf(std::size_t cells)
        : labels_(new Label[cells]), reached_(zeros(cells / 64)), expanded_(zeros(cells / 64)),
          listed_(zeros(cells / 4096 + 1)), cells_(cells)
    {
    }

    std::size_t size() const { return cells_; }

    /// Takes all memory from the system now, not page by page during the first search.
    void takeMemory() { std::fill_n(labels_.get(), cells_, Label{}); }

    bool isReached(CellIndex cell) const { return (reached_[cell >> 6] >> (cell & 63)) & 1; }
    bool isExpanded(CellIndex cell) const { return (expanded_[cell >> 6] >> (cell & 63)) & 1; }

    /// The label of a cell that was reached.
    Label label(CellIndex cell) const { return labels_[cell]; }
    void setLabel(CellIndex cell, Label label) { labels_[cell] = label; }

    void markReached(CellIndex cell)
    {
        std::uint64_t &word = reached_[cell >> 6];
        if (word == 0)
            list(cell >> 6);
        word |= std::uint64_t{1} << (cell & 63);
    }
    /// As if the cell had never been reached.
    void forget(CellIndex cell)
    {
        reached_[cell >> 6] &= ~(std::uint64_t{1} << (cell & 63));
        unmarkExpanded(cell);
    }

    void markExpanded(CellIndex cell) { expanded_[cell >> 6] |= std::uint64_t{1} << (cell & 63); }
    void unmarkExpanded(CellIndex cell) { expanded_[cell >> 6] &= ~(std::uint64_t{1} << (cell & 63)); }

    /// 64 cells at a time; `word` below size() / 64.
    std::uint64_t reachedWord(std::size_t word) const { return reached_[word]; }
    /// Reached and not expanded.
    std::uint64_t openWord(std::size_t word) const { return reached_[word] & ~expanded_[word]; }

    void clear()
    {
        for (const std::uint32_t word : touchedWords_)
            reached_[word] = expanded_[word] = listed_[word >> 6] = 0;
        touchedWords_.clear();
    }

    /// Words of 64 cells of which one was reached since clear(), in the order of reaching, each once.
    const std::vector<std::uint32_t> &touchedWords() const { return touchedWords_; }

private:
    struct Free
    {
        void operator()(std::uint64_t *words) const { std::free(words); }
    };
    using Words = std::unique_ptr<std::uint64_t[], Free>;

    static Words zeros(std::size_t count)
    {
        // unlike `new`, calloc leaves fresh pages of zeros alone
        Words words(static_cast<std::uint64_t *>(std::calloc(count, sizeof(std::uint64_t))));
        if (!words)
            throw std::bad_alloc();
        return words;
    }

    // a word whose cells were all forgotten is listed already
    void list(std::uint32_t word)
    {
        const std::uint64_t bit = std::uint64_t{1} << (word & 63);
        if ((listed_[word >> 6] & bit) == 0)
            touchedWords_.push_back(word);
        listed_[word >> 6] |= bit;
    }

    std::unique_ptr<Label[]> labels_;
    Words reached_;
    Words expanded_;
    Words listed_;  // one bit for each of touchedWords_
    std::vector<std::uint32_t> touchedWords_;
    std::size_t cells_;
};

using LabelStore = LabelStoreOf<std::uint32_t>;

}  // namespace seahex
