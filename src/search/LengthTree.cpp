#include "seahex/search/LengthTree.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace seahex
{
namespace
{

constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max();

std::vector<HexCoord> offsetsOf(const HexJumps &jumps)
{
    std::vector<HexCoord> offsets;
    for (std::size_t k = 0; k < jumps.size(); ++k)
        offsets.push_back(jumps.offset(k).offset);
    return offsets;
}

std::int64_t normOf(const units::RingNorm &norm, HexCoord difference)
{
    return norm(static_cast<std::int32_t>(difference.q), static_cast<std::int32_t>(difference.s));
}

}  // namespace

LengthTree::LengthTree(std::shared_ptr<const Occupancy> occupancy, int rings)
    : occupancy_(std::move(occupancy)), layout_(occupancy_->layout()), jumps_(layout_, rings, JumpSet::Primitive),
      blocked_(layout_, occupancy_->words().data()), store_(layout_.size()), natural_(NaturalJumps::ofRings(rings)),
      norm_(rings), cones_(rings, offsetsOf(jumps_)), lengths_(), deltas_(), leastReopened_(unlimited), addedHere_(),
      near_(layout_), cut_(layout_)
{
    constexpr std::int64_t most = std::int64_t{1} << 27;
    if (layout_.columns() > most || layout_.rows() > most)
        throw std::length_error("a search by length takes at most 2^27 columns and rows");
    for (std::size_t k = 0; k < jumps_.size(); ++k)
    {
        lengths_[k] = normOf(norm_, jumps_.offset(k).offset);
        for (int parity = 0; parity < 2; ++parity)
            deltas_[static_cast<std::size_t>(parity)][k] = jumps_.from(parity)[k].delta;
    }
}

void LengthTree::clear()
{
    store_.clear();
    counters_ = {};
    cutOff_ = 0;
    root_.reset();
    aim_.reset();
    isOpenStale_ = true;
    passed_ = -1;
}

void LengthTree::plant(HexCoord root)
{
    clear();
    root_ = root;
    if (!isFreeCell(root))
        return;
    const CellIndex cell = layout_.index(root);
    store_.markReached(cell);
    store_.setLabel(cell, noJump);
    ++counters_.generated;
}

bool LengthTree::isFreeCell(HexCoord cell) const
{
    return occupancy_->isFree(toOffset(cell));
}

SearchStatus LengthTree::growTo(HexCoord target, const std::function<bool()> &stop, std::uint64_t pollInterval)
{
    if (!root_ || !isFreeCell(target))
        return SearchStatus::Exhausted;
    const CellIndex cell = layout_.index(target);
    if (isKnown(cell))
        return SearchStatus::Found;
    if (isOpenStale_ || aim_ != target)
        aimAt(target);
    return grow(cell, stop, pollInterval);
}

/// What a path through a reached cell to the target costs at least.
std::int64_t LengthTree::estimate(CellIndex cell) const
{
    return aim_ ? lengthInUnits(cell) + normOf(norm_, *aim_ - layout_.cell(cell)) : unlimited;
}

/// Gives the open cells the keys of another target; those that a path known beats stay out of the queue.
void LengthTree::aimAt(HexCoord target)
{
    const CellIndex goal = layout_.index(target);
    const std::int64_t beaten = store_.isReached(goal) ? lengthInUnits(goal) : unlimited;
    aim_ = target;
    passed_ = -1;
    leastReopened_ = unlimited;
    open_.clear();
    for (const std::uint32_t word : store_.touchedWords())
        for (std::uint64_t bits = store_.openWord(word); bits != 0; bits &= bits - 1)
        {
            const CellIndex cell = 64 * word + static_cast<CellIndex>(__builtin_ctzll(bits));
            const std::int64_t estimate = this->estimate(cell);
            if (estimate < beaten)
                open_.add(estimate, cell);
        }
    open_.begin();
    isOpenStale_ = false;
}

SearchStatus LengthTree::grow(CellIndex target, const std::function<bool()> &stop, std::uint64_t pollInterval)
{
    std::uint64_t untilPoll = 0;
    for (;;)
    {
        if (open_.isCurrentEmpty())
        {
            const bool isLeft = open_.advance();
            if (store_.isReached(target) && (!isLeft || lengthInUnits(target) <= open_.least()))
            {
                passed_ = lengthInUnits(target);
                return SearchStatus::Found;
            }
            if (!isLeft)
            {
                passed_ = unlimited;
                return SearchStatus::Exhausted;
            }
        }
        if (untilPoll-- == 0)
        {
            if (stop && stop())
                return SearchStatus::Stopped;
            untilPoll = pollInterval - 1;
        }
        const CellIndex cell = open_.pop();
        if (store_.isExpanded(cell))
            continue;
        const HexCoord left = *aim_ - layout_.cell(cell);
        const std::int64_t estimate = lengthInUnits(cell) + normOf(norm_, left);
        // beaten by the target: it stays open, though not in the queue, for targets to come
        if (!store_.isReached(target) || estimate < lengthInUnits(target))
            expand(cell, left, estimate);
    }
}

inline const std::uint32_t *LengthTree::added(HexCoord left, std::uint32_t jumps)
{
    const auto q = static_cast<std::int32_t>(left.q);
    const auto s = static_cast<std::int32_t>(left.s);
    if (cone_ != nullptr && cone_->holds(q, s))
        return cone_->added.data();
    cone_ = cones_.find(q, s);
    if (cone_ != nullptr)
        return cone_->added.data();
    const std::int64_t here = norm_(q, s);
    for (; jumps != 0; jumps &= jumps - 1)
    {
        const auto k = static_cast<std::size_t>(__builtin_ctz(jumps));
        addedHere_[k] = static_cast<std::uint32_t>(lengths_[k] + normOf(norm_, left - jumps_.offset(k).offset) - here);
    }
    return addedHere_.data();
}

inline void LengthTree::expand(CellIndex cell, HexCoord left, std::int64_t estimate)
{
    store_.markExpanded(cell);
    ++counters_.expanded;
    const std::int64_t length = lengthInUnits(cell);
    // the row's parity, from what is left to the aim
    const auto parity = static_cast<unsigned int>((aim_->s - left.s) & 1);
    const NaturalJumps::Arrival &arrival = natural_.arrival(parity, arrivedBy(cell));
    const std::uint32_t jumps = natural_.toTry(arrival, blocked_.around(cell));
    const std::uint32_t *added = this->added(left, jumps);
    for (std::uint32_t rest = jumps; rest != 0; rest &= rest - 1)
    {
        const auto jump = static_cast<unsigned int>(__builtin_ctz(rest));
        reach(cell + static_cast<CellIndex>(deltas_[parity][jump]), length + lengths_[jump], estimate + added[jump],
              jump);
    }
}

inline void LengthTree::reach(CellIndex cell, std::int64_t length, std::int64_t estimate, unsigned int jump)
{
    if (store_.isReached(cell))
    {
        if (length >= lengthInUnits(cell))
            return;
        ++counters_.improved;
        if (store_.isExpanded(cell))
        {
            ++counters_.reopened;
            store_.unmarkExpanded(cell);
        }
    }
    else
    {
        store_.markReached(cell);
        ++counters_.generated;
    }
    store_.setLabel(cell, static_cast<Label>(length) << jumpBits | jump);
    open_.push(estimate, cell);
}

double LengthTree::length(HexCoord cell) const
{
    if (!isFreeCell(cell) || !store_.isReached(layout_.index(cell)))
        return std::numeric_limits<double>::infinity();
    double length = 0.0;
    for (CellIndex at = layout_.index(cell); arrivedBy(at) != noJump; at = jumps_.predecessor(at, arrivedBy(at)))
        length += jumps_.length(arrivedBy(at));
    return length;
}

std::vector<CellIndex> LengthTree::path(HexCoord cell) const
{
    if (!isFreeCell(cell) || !store_.isReached(layout_.index(cell)))
        return {};
    std::vector<CellIndex> cells = {layout_.index(cell)};
    for (CellIndex at = cells.front(); arrivedBy(at) != noJump; cells.push_back(at))
        at = jumps_.predecessor(at, arrivedBy(at));
    std::reverse(cells.begin(), cells.end());
    return cells;
}

}  // namespace seahex
