#include "seahex/search/LengthSearch.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace seahex
{
namespace
{

std::vector<HexCoord> offsetsOf(const HexJumps &jumps, int rings)
{
    std::vector<HexCoord> offsets;
    for (std::size_t k = 0; k < jumps.countWithin(rings); ++k)
        offsets.push_back(jumps.offset(k).offset);
    return offsets;
}

unsigned int bitsOf(std::uint64_t value)
{
    return 64 - static_cast<unsigned int>(__builtin_clzll(value));
}

}  // namespace

LengthSearch::LengthSearch(const Occupancy &occupancy, int rings)
    : layout_(occupancy.layout()), jumps_(layout_, 3, JumpSet::Primitive), blocked_(layout_, occupancy.words().data()),
      store_(layout_.size()), natural_(&NaturalJumps::ofRings(rings)), norm_(rings),
      cones_(rings, offsetsOf(jumps_, rings)), rings_(rings), deltas_(), jumpQ_(), jumpS_(), addedHere_()
{
    constexpr std::int64_t most = std::int64_t{1} << 27;
    if (layout_.columns() > most || layout_.rows() > most)
        throw std::length_error("a search by length takes at most 2^27 columns and rows");
    for (std::size_t k = 0; k < jumps_.size(); ++k)
    {
        for (int parity = 0; parity < 2; ++parity)
            deltas_[static_cast<std::size_t>(parity)][k] = jumps_.from(parity)[k].delta;
        jumpQ_[k] = static_cast<std::int32_t>(jumps_.offset(k).offset.q);
        jumpS_[k] = static_cast<std::int32_t>(jumps_.offset(k).offset.s);
    }
    // A row is the word of the cell divided by the words of a row: both below 2^26, so that the quotient is exact with
    // a reciprocal of 26 bits more than the divisor has [Granlund1994].
    const auto rowWords = static_cast<std::uint64_t>(layout_.stride() / 64);
    rowShift_ = 26 + bitsOf(rowWords);
    rowReciprocal_ = (std::uint64_t{1} << rowShift_) / rowWords + 1;
}

void LengthSearch::useRings(int rings)
{
    natural_ = &NaturalJumps::ofRings(rings);
    norm_ = units::RingNorm(rings);
    cones_ = NormCones(rings, offsetsOf(jumps_, rings));
    rings_ = rings;
}

void LengthSearch::forget()
{
    store_.clear();
    open_.clear();
    counters_ = {};
    bestGoal_.reset();
    bucketsPassed_ = 0;
    cone_ = nullptr;
}

void LengthSearch::begin(HexCoord start, HexCoord goal)
{
    forget();
    goal_ = layout_.index(goal);
    goalQ_ = static_cast<std::int32_t>(goal.q);
    goalS_ = static_cast<std::int32_t>(goal.s);
    const HexCoord left = goal - start;
    startBound_ = norm_(static_cast<std::int32_t>(left.q), static_cast<std::int32_t>(left.s));
    open_.beginAt(0);
    reach(layout_.index(start), 0, noJump);
}

SearchStatus LengthSearch::run(const std::function<bool()> &stop, std::uint64_t pollInterval)
{
    std::uint64_t untilPoll = 0;
    while (!open_.empty())
    {
        if (open_.isCurrentEmpty())
        {
            if (bestGoal_)
                return SearchStatus::Found;
            bucketsPassed_ += open_.advance();
        }
        if (untilPoll-- == 0)
        {
            if (stop && stop())
                return SearchStatus::Stopped;
            untilPoll = pollInterval - 1;
        }
        const CellIndex cell = open_.pop();
        if (!store_.isExpanded(cell) && !isBeatenByGoal(cell))
            expand(cell);
    }
    return bestGoal_ ? SearchStatus::Found : SearchStatus::Exhausted;
}

inline LengthSearch::Place LengthSearch::placeOf(CellIndex cell) const
{
    const auto row = static_cast<std::int32_t>(((cell >> 6) * rowReciprocal_) >> rowShift_);
    const auto column =
        static_cast<std::int32_t>(cell) - row * static_cast<std::int32_t>(layout_.stride()) - CellLayout::frame;
    const std::int32_t s = row - static_cast<std::int32_t>(CellLayout::frame);
    const std::int32_t parity = s & 1;
    const auto q = static_cast<std::int32_t>(column) - (s + parity) / 2;
    return {static_cast<unsigned int>(parity), goalQ_ - q, goalS_ - s};
}

inline const std::uint32_t *LengthSearch::added(const Place &place, std::uint32_t jumps)
{
    if (cone_ != nullptr && cone_->holds(place.q, place.s))
        return cone_->added.data();
    if (const NormCones::Cone *cone = cones_.find(place.q, place.s))
    {
        cone_ = cone;
        return cone->added.data();
    }
    const std::int64_t here = norm_(place.q, place.s);
    for (; jumps != 0; jumps &= jumps - 1)
    {
        const auto k = static_cast<std::size_t>(__builtin_ctz(jumps));
        addedHere_[k] = static_cast<std::uint32_t>(norm_(jumpQ_[k], jumpS_[k]) +
                                                   norm_(place.q - jumpQ_[k], place.s - jumpS_[k]) - here);
    }
    return addedHere_.data();
}

/// What is left in the goal's bucket may be better than the goal, or not.
inline bool LengthSearch::isBeatenByGoal(CellIndex cell) const
{
    return bestGoal_ && static_cast<std::int32_t>(store_.label(cell) - (*bestGoal_ << jumpBits)) >= 0;
}

inline void LengthSearch::expand(CellIndex cell)
{
    store_.markExpanded(cell);
    ++counters_.expanded;
    if (trace_ != nullptr)
        trace_->push_back(cell);
    const std::uint32_t label = store_.label(cell);
    const std::uint32_t estimate = label >> jumpBits;
    if (cell == goal_)
    {
        bestGoal_ = estimate;
        return;
    }
    const Place place = placeOf(cell);
    const NaturalJumps::Arrival &arrival = natural_->arrival(place.parity, label & jumpMask);
    const std::uint32_t jumps = natural_->toTry(arrival, blocked_.around(cell));
    const std::uint32_t *added = this->added(place, jumps);
    const std::array<std::int32_t, mostJumps> &deltas = deltas_[place.parity];
    for (std::uint32_t left = jumps; left != 0; left &= left - 1)
    {
        const auto jump = static_cast<unsigned int>(__builtin_ctz(left));
        reach(cell + static_cast<CellIndex>(deltas[jump]), estimate + added[jump], jump);
    }
}

inline void LengthSearch::reach(CellIndex cell, std::uint32_t estimate, unsigned int jump)
{
    const std::uint32_t label = estimate << jumpBits | jump;
    if (store_.isReached(cell))
    {
        // compared modulo 2^32: estimates lie close together, and of equal ones the first stays
        const std::uint32_t known = store_.label(cell) & ~jumpMask;
        if (static_cast<std::int32_t>((label & ~jumpMask) - known) >= 0)
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
    store_.setLabel(cell, label);
    open_.push(label >> jumpBits, cell);
}

double LengthSearch::cost() const
{
    if (!bestGoal_)
        return std::numeric_limits<double>::infinity();
    double length = 0.0;
    for (CellIndex cell = goal_; arrivedBy(cell) != noJump; cell = jumps_.predecessor(cell, arrivedBy(cell)))
        length += jumps_.length(arrivedBy(cell));
    return length;
}

std::vector<CellIndex> LengthSearch::pathTo(CellIndex cell) const
{
    std::vector<CellIndex> cells = {cell};
    for (; arrivedBy(cell) != noJump; cells.push_back(cell))
        cell = jumps_.predecessor(cell, arrivedBy(cell));
    std::reverse(cells.begin(), cells.end());
    return cells;
}

double LengthSearch::lowerBound() const
{
    if (open_.empty() || (bestGoal_ && open_.isCurrentEmpty()))
        return cost();
    // every open cell's estimate lies in the current bucket or above
    const double passed = static_cast<double>(bucketsPassed_) * static_cast<double>(1U << BucketQueue::shift);
    const double bound = (static_cast<double>(startBound_) + passed) / static_cast<double>(units::pitch);
    return std::min(bound * (1.0 - units::error), cost());
}

}  // namespace seahex
