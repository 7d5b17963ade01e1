// What LengthTree does when cells change.

#include "seahex/search/LengthTree.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace seahex
{

void LengthTree::setOccupancy(std::shared_ptr<const Occupancy> occupancy)
{
    if (occupancy == occupancy_)
        return;
    if (occupancy->layout().columns() != layout_.columns() || occupancy->layout().rows() != layout_.rows())
        throw std::length_error("the changed occupancy is not of the same lattice");
    const CellWords before = occupancy_->words();
    const CellWords now = occupancy->words();
    bool isAnyFreed = false;
    for (std::size_t word = 0; word < now.size(); ++word)
        if (const std::uint64_t changed = before[word] ^ now[word])
        {
            near_.addAround(word, changed);
            isAnyFreed = isAnyFreed || (changed & before[word]) != 0;
        }
    occupancy_ = std::move(occupancy);
    blocked_ = HexWindow(layout_, now.data());
    if (!root_ || near_.empty())
    {
        near_.clear();
        return;
    }
    if (!isFreeCell(*root_) || !store_.isReached(layout_.index(*root_)))
    {
        near_.clear();
        plant(*root_);
        return;
    }

    repair();
    if (isAnyFreed)
        passed_ = std::min(passed_, leastReopened_);
}

/// Makes labels true again after the cells in near_ changed, or those around.
void LengthTree::repair()
{
    const auto forEachReachedNear = [this](const auto &visit)
    {
        near_.forEach(
            [this, &visit](CellIndex cell)
            {
                if (store_.isReached(cell))
                    visit(cell);
            });
        near_.clear();
    };
    forEachReachedNear(
        [this](CellIndex cell)
        {
            reopen(cell);
            if (!isArrivalValid(cell))
                loose_.add(lengthInUnits(cell), cell);
        });
    loose_.begin();
    while (!loose_.isCurrentEmpty() || loose_.advance())
    {
        const CellIndex cell = loose_.pop();
        if (store_.isReached(cell) && !isArrivalValid(cell))
            joinElsewhereOrCutOff(cell);
    }
    loose_.clear();
    cut_.forEachWord([this](std::size_t word, std::uint64_t bits) { near_.addAround(word, bits); });
    cut_.clear();
    forEachReachedNear([this](CellIndex cell) { reopen(cell); });
    isOpenStale_ = true;
}

/// Does the jump that led to a reached cell still come from a reached cell, through free ones?
bool LengthTree::isArrivalValid(CellIndex cell) const
{
    const std::uint8_t jump = arrivedBy(cell);
    if (jump == noJump)
        return true;  // the root is free
    const CellIndex from = jumps_.predecessor(cell, jump);
    const Jump &steps = jumps_.from(jumps_.parity(from))[jump];
    return store_.isReached(from) &&
           std::none_of(jumps_.touched() + steps.firstTouch, jumps_.touched() + steps.endTouch,
                        [&](std::int32_t delta)
                        { return occupancy_->isBlockedAt(from + static_cast<CellIndex>(delta)); });
}

/// Finds another arrival for a loose cell by which it is no farther from the root; if there is none, forgets the cell,
/// and those that were reached from it are loose. Loose cells nearer to the root were seen to before (no jump is
/// shorter than a bucket), so that where it comes from is not loose itself. By another arrival other jumps are to be
/// tried: the cell is near a cut or a changed cell, and opened again with all that are.
void LengthTree::joinElsewhereOrCutOff(CellIndex cell)
{
    const auto parity = static_cast<unsigned int>(jumps_.parity(cell));
    const bool isBlocked = occupancy_->isBlockedAt(cell);
    const std::int64_t length = lengthInUnits(cell);
    std::int64_t least = isBlocked ? -1 : length;
    std::size_t best = jumps_.size();
    std::array<CellIndex, mostJumps> reachedFromHere;
    std::size_t count = 0;
    // what was reached by a jump that is no longer valid is loose already
    std::uint32_t valid = natural_.toTry(natural_.arrival(parity, noJump), blocked_.around(cell));
    for (; valid != 0; valid &= valid - 1)
    {
        const auto jump = static_cast<std::size_t>(__builtin_ctz(valid));
        const CellIndex other = cell + static_cast<CellIndex>(deltas_[parity][jump]);
        if (!store_.isReached(other))
            continue;
        const Label label = store_.label(other);
        const std::int64_t fromThere = static_cast<std::int64_t>(label >> jumpBits) + lengths_[jump];
        if (fromThere <= least)
        {
            least = fromThere;
            best = jump;
        }
        else if ((label & jumpMask) == jump)
            reachedFromHere[count++] = other;
    }
    if (best != jumps_.size())
    {
        store_.setLabel(cell, static_cast<Label>(least) << jumpBits | jumps_.opposite(best));
        return;
    }
    store_.forget(cell);
    cut_.add(cell);
    ++cutOff_;
    for (std::size_t k = 0; k < count; ++k)
        loose_.pushAnywhere(lengthInUnits(reachedFromHere[k]), reachedFromHere[k]);
}

void LengthTree::reopen(CellIndex cell)
{
    store_.unmarkExpanded(cell);
    leastReopened_ = std::min(leastReopened_, estimate(cell));
}

}  // namespace seahex
