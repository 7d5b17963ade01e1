#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace seahex
{

/// The 64-bit words of an occupancy: immutable, wherever they lie (in memory of their own, or in a mapped file), and
/// alive for as long as a copy of this is. Copies share them.
class CellWords
{
public:
    using value_type = std::uint64_t;
    using const_iterator = const std::uint64_t *;

    /// No words.
    CellWords() = default;

    /// Words in memory of their own. An implicit conversion, because it loses nothing.
    CellWords(std::vector<std::uint64_t> words)
        : CellWords(std::make_shared<const std::vector<std::uint64_t>>(std::move(words)))
    {
    }

    /// Words that an owner keeps.
    CellWords(std::shared_ptr<const void> owner, const std::uint64_t *data, std::size_t size)
        : owner_(std::move(owner)), data_(data), size_(size)
    {
    }

    const std::uint64_t *data() const { return data_; }
    std::size_t size() const { return size_; }
    const_iterator begin() const { return data_; }
    const_iterator end() const { return data_ + size_; }
    std::uint64_t operator[](std::size_t i) const { return data_[i]; }

    friend bool operator==(const CellWords &a, const CellWords &b)
    {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }
    friend bool operator!=(const CellWords &a, const CellWords &b) { return !(a == b); }

private:
    explicit CellWords(const std::shared_ptr<const std::vector<std::uint64_t>> &words)
        : CellWords(words, words->data(), words->size())
    {
    }

    std::shared_ptr<const void> owner_;
    const std::uint64_t *data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace seahex
