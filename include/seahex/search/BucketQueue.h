#pragma once

#include <seahex/geometry/CellLayout.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace seahex
{

/// The open list of a search whose keys are whole numbers and grow by little: a ring of buckets, each a stack.
///
/// A bucket holds the cells of 2^`shift` neighbouring keys; within it the last one comes out first, so that of many
/// equally good cells one is followed to its end. Keys may lie at most `buckets` - 1 buckets above the least. Push and
/// pop take constant time; the cells lie in blocks that are used again.
class BucketQueue
{
public:
    static constexpr unsigned int shift = 11;
    static constexpr std::uint32_t buckets = 256;

    /// Keys are counted modulo 2^32; what lies above is the caller's.
    void push(std::uint32_t key, CellIndex cell)
    {
        const std::uint32_t bucket = (key >> shift) % buckets;
        Block *&top = tops_[bucket];
        if (top == nullptr || top->count == Block::capacity)
            top = takeBlock(top, bucket);
        top->cells[top->count++] = cell;
        ++size_;
    }

    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }

    /// The bucket whose cells come out; the caller moves it on when it is empty.
    std::uint32_t current() const { return current_; }
    bool isCurrentEmpty() const { return tops_[current_] == nullptr; }
    /// To the next bucket that holds a cell; the queue must not be empty.
    /// @return by how many buckets
    std::uint32_t advance()
    {
        std::uint32_t steps = 0;
        for (; tops_[current_] == nullptr; ++steps)
            current_ = (current_ + 1) % buckets;
        return steps;
    }
    void beginAt(std::uint32_t key) { current_ = (key >> shift) % buckets; }

    /// The last cell that the current bucket got.
    CellIndex pop()
    {
        Block *&top = tops_[current_];
        const CellIndex cell = top->cells[--top->count];
        --size_;
        if (top->count == 0)
            giveBack(top);
        return cell;
    }

    void clear()
    {
        for (Block *&top : tops_)
            while (top != nullptr)
                giveBack(top);
        size_ = 0;
    }

    /// Memory held, in bytes.
    std::size_t bytes() const { return blocks_.size() * sizeof(Block); }

private:
    struct Block
    {
        static constexpr std::uint32_t capacity = 125;

        Block *below;
        std::uint32_t count;
        CellIndex cells[capacity];
    };

    Block *takeBlock(Block *below, std::uint32_t)
    {
        if (free_ == nullptr)
        {
            blocks_.push_back(std::make_unique<Block>());
            free_ = blocks_.back().get();
            free_->below = nullptr;
        }
        Block *const block = free_;
        free_ = block->below;
        block->below = below;
        block->count = 0;
        return block;
    }

    void giveBack(Block *&top)
    {
        Block *const block = top;
        top = block->below;
        block->below = free_;
        free_ = block;
    }

    Block *tops_[buckets] = {};
    Block *free_ = nullptr;
    std::uint32_t current_ = 0;
    std::size_t size_ = 0;
    std::vector<std::unique_ptr<Block>> blocks_;
};

}  // namespace seahex
