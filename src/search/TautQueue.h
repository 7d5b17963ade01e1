#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace seahex
{

/// What waits to be expanded in a TautSearch.
struct TautNode
{
    enum class Kind : std::uint32_t
    {
        Southward,  ///< an interval where a row is entered from the north
        Northward,  ///< an interval where a row is entered from the south
        Corner,     ///< a corner with the length of the way to it, in `west`
        Goal        ///< the goal seen from the root
    };

    double estimate;  ///< lower bound of a path through it
    double west;
    double east;
    std::uint32_t root;
    std::uint32_t rowAndKind;
    std::uint32_t westCorner;  ///< the last corner on the western ray; 0 if none is known
    std::uint32_t eastCorner;

    Kind kind() const { return static_cast<Kind>(rowAndKind & 3U); }
    std::int64_t row() const { return rowAndKind >> 2; }
    static std::uint32_t pack(std::int64_t row, Kind kind)
    {
        return static_cast<std::uint32_t>(row) << 2 | static_cast<std::uint32_t>(kind);
    }
};

/// Nodes by their estimates: a heap with four children a node, and beside it the best node that came since the last was
/// taken. As a rule that one is next, and never goes through the heap.
class TautQueue
{
public:
    bool empty() const { return !hasFresh_ && heap_.empty(); }

    void clear()
    {
        heap_.clear();
        hasFresh_ = false;
    }

    /// The least estimate; the queue must not be empty.
    double least() const
    {
        if (!hasFresh_)
            return heap_.front().estimate;
        return heap_.empty() || fresh_.estimate <= heap_.front().estimate ? fresh_.estimate : heap_.front().estimate;
    }

    void push(const TautNode &node)
    {
        if (!hasFresh_)
        {
            fresh_ = node;
            hasFresh_ = true;
        }
        else if (node.estimate < fresh_.estimate)
        {
            raise(fresh_);
            fresh_ = node;
        }
        else
            raise(node);
    }

    TautNode take()
    {
        if (hasFresh_)
        {
            hasFresh_ = false;
            if (heap_.empty() || fresh_.estimate <= heap_.front().estimate)
                return fresh_;
            const TautNode top = heap_.front();
            sink(fresh_);
            return top;
        }
        const TautNode top = heap_.front();
        const TautNode last = heap_.back();
        heap_.pop_back();
        if (!heap_.empty())
            sink(last);
        return top;
    }

private:
    void raise(const TautNode &node)
    {
        std::size_t i = heap_.size();
        heap_.push_back(node);
        while (i > 0)
        {
            const std::size_t parent = (i - 1) / 4;
            if (heap_[parent].estimate <= node.estimate)
                break;
            heap_[i] = heap_[parent];
            i = parent;
        }
        heap_[i] = node;
    }

    /// Puts a node in the place of the top, and lets it sink.
    void sink(const TautNode &node)
    {
        const std::size_t size = heap_.size();
        std::size_t i = 0;
        for (std::size_t child = 1; child < size; child = 4 * i + 1)
        {
            const std::size_t end = child + 4 < size ? child + 4 : size;
            std::size_t best = child;
            for (std::size_t k = child + 1; k < end; ++k)
                if (heap_[k].estimate < heap_[best].estimate)
                    best = k;
            if (node.estimate <= heap_[best].estimate)
                break;
            heap_[i] = heap_[best];
            i = best;
        }
        heap_[i] = node;
    }

    std::vector<TautNode> heap_;
    TautNode fresh_ = {};
    bool hasFresh_ = false;
};

}  // namespace seahex
