#pragma once

#include <seahex/geometry/CellLayout.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace seahex
{

/// A cell waiting to be expanded.
struct OpenEntry
{
    double key;  ///< estimated cost of the whole path through the cell
    double tie;  ///< among equal keys the smaller one goes first
    CellIndex cell;
};

/// The open list of a best-first search: a heap with four children a node (half as deep as a binary one, and the
/// children lie in two cache lines). A cell may be in it several times; whoever pops it skips the outdated ones.
template <class Before>
class OpenList
{
public:
    explicit OpenList(Before before) : before_(std::move(before)) {}

    bool empty() const { return heap_.empty(); }
    std::size_t size() const { return heap_.size(); }
    /// What it holds, room for more entries included.
    std::size_t capacityBytes() const { return heap_.capacity() * sizeof(OpenEntry); }
    const OpenEntry &top() const { return heap_.front(); }
    void clear() { heap_.clear(); }

    void push(const OpenEntry &entry)
    {
        std::size_t i = heap_.size();
        heap_.push_back(entry);
        while (i > 0)
        {
            const std::size_t parent = (i - 1) / 4;
            if (!before_(entry, heap_[parent]))
                break;
            heap_[i] = heap_[parent];
            i = parent;
        }
        heap_[i] = entry;
    }

    void pop()
    {
        const OpenEntry last = heap_.back();
        heap_.pop_back();
        if (!heap_.empty())
            sink(0, last);
    }

    /// Calls renew(entry) for every entry, which may change it, keeps those for which that is true, and puts them in
    /// order.
    template <class Renew>
    void renew(Renew &&renew)
    {
        heap_.erase(std::remove_if(heap_.begin(), heap_.end(), [&](OpenEntry &entry) { return !renew(entry); }),
                    heap_.end());
        for (std::size_t i = (heap_.size() + 2) / 4; i-- > 0;)
            sink(i, OpenEntry(heap_[i]));
    }

private:
    /// Puts an entry where node i is, or as far below as it belongs.
    void sink(std::size_t i, const OpenEntry &entry)
    {
        const std::size_t size = heap_.size();
        for (std::size_t child = 4 * i + 1; child < size; child = 4 * i + 1)
        {
            const std::size_t end = child + 4 < size ? child + 4 : size;
            std::size_t best = child;
            for (std::size_t k = child + 1; k < end; ++k)
                if (before_(heap_[k], heap_[best]))
                    best = k;
            if (!before_(heap_[best], entry))
                break;
            heap_[i] = heap_[best];
            i = best;
        }
        heap_[i] = entry;
    }

    Before before_;
    std::vector<OpenEntry> heap_;
};

}  // namespace seahex
