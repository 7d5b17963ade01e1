#pragma once

#include <seahex/search/BucketQueue.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace seahex
{

/// A BucketQueue that may begin with keys of any spread: the open list of a search that goes on with cells which
/// another search, towards another goal, has left open.
///
/// Keys that lie too far above the least for the ring of buckets wait in a heap, made in linear time; most are never
/// looked at again.
class SpreadQueue
{
public:
    void clear()
    {
        near_.clear();
        far_.clear();
    }

    /// Between clear() and begin(): a cell with any key >= 0.
    void add(std::int64_t key, CellIndex cell) { far_.push_back({key, cell}); }
    void begin()
    {
        std::make_heap(far_.begin(), far_.end(), isLater);
        if (!far_.empty())
            moveTo(far_.front().key >> BucketQueue::shift);
    }

    /// After begin(): a key that is no less than least() and at most BucketQueue::buckets - 2 buckets above.
    void push(std::int64_t key, CellIndex cell) { near_.push(static_cast<std::uint32_t>(key), cell); }
    /// After begin(): any key that is no less than least().
    void pushAnywhere(std::int64_t key, CellIndex cell)
    {
        if (key < nearEnd())
            return push(key, cell);
        add(key, cell);
        std::push_heap(far_.begin(), far_.end(), isLater);
    }

    /// The bucket whose cells come out; the caller moves it on when it is empty.
    bool isCurrentEmpty() const { return near_.isCurrentEmpty(); }
    CellIndex pop() { return near_.pop(); }
    /// No key that is left lies below.
    std::int64_t least() const { return bucket_ << BucketQueue::shift; }

    /// To the next bucket that holds a cell. @return false if none is left
    bool advance()
    {
        if (!near_.empty())
            takeNear(bucket_ + near_.advance());
        else if (!far_.empty())
            moveTo(far_.front().key >> BucketQueue::shift);
        else
            return false;
        return true;
    }

private:
    struct Entry
    {
        std::int64_t key;
        CellIndex cell;
    };

    static bool isLater(const Entry &a, const Entry &b) { return a.key > b.key; }

    void moveTo(std::int64_t bucket)
    {
        near_.beginAt(static_cast<std::uint32_t>(bucket << BucketQueue::shift));
        takeNear(bucket);
    }

    std::int64_t nearEnd() const { return (bucket_ + BucketQueue::buckets) << BucketQueue::shift; }

    void takeNear(std::int64_t bucket)
    {
        bucket_ = bucket;
        while (!far_.empty() && far_.front().key < nearEnd())
        {
            push(far_.front().key, far_.front().cell);
            std::pop_heap(far_.begin(), far_.end(), isLater);
            far_.pop_back();
        }
    }

    BucketQueue near_;
    std::vector<Entry> far_;
    std::int64_t bucket_ = 0;
};

}  // namespace seahex
