#pragma once

#include <seahex/geometry/HexWindow.h>
#include <seahex/search/CellSet.h>
#include <seahex/search/HexJumps.h>
#include <seahex/search/LabelStore.h>
#include <seahex/search/NaturalJumps.h>
#include <seahex/search/NormCones.h>
#include <seahex/search/SearchCounters.h>
#include <seahex/search/SearchStatus.h>
#include <seahex/search/SpreadQueue.h>
#include <seahex/search/UnitLengths.h>
#include <seahex/world/Occupancy.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace seahex
{

/// The shortest chains of ring jumps from one cell, the root, to others: a tree that is kept from one question to the
/// next, where LengthSearch forgets. It grows towards one target after the other, and is repaired when cells change.
///
/// What is searched, and how, is as in LengthSearch; lengths are the same. Jumps are as long there as back, so a route
/// may as well be asked for from its goal: then the tree answers wherever the vessel is.
///
/// Why it may be kept. Call a cell closed if it was expanded since it got its label, and the cells around it changed.
/// Whatever was done before, in whatever order: if a reached cell's length is not the least, then some cell that is
/// not closed lies on a best path to it with its least length (follow that best path of which NaturalJumps speaks, back
/// to the last cell that has its least length: were it closed, it would have handed it on). So with a consistent bound
/// h of the length left to the target, a length g is least once no open cell has a smaller g + h. Nothing in
/// this depends on the target for which a cell was expanded, so:
/// - Another target needs other keys for the open cells, and no cell is expanded again.
/// - A target whose g + h, towards the last target, is no more than what was passed on the way there, is known at once.
/// - When cells change, the branches that are no longer valid are cut off, and cells beside the cuts and around the
///   changed cells are opened again. What was passed holds on if cells were only blocked: lengths only grow. If cells
///   were freed, it holds up to the least g + h of the cells that were opened again.
///
/// Limits: a change behind which much of the tree lies (nearer to the root than most of it) cuts off as much, and is
/// as dear as a search from there on. Memory: 8 bytes and 2 bits for each cell ever touched, 4 bits for every other.
/// One thread at a time.
class LengthTree
{
public:
    /// In the place of a jump at the root.
    static constexpr std::uint8_t noJump = NaturalJumps::start;

    /// @param occupancy  of hexagons
    /// @param rings  1, 2 or 3
    /// @throws std::length_error for more than 2^27 columns or rows
    LengthTree(std::shared_ptr<const Occupancy> occupancy, int rings);

    /// Begins anew from another root, a cell of the lattice; if it is blocked, nothing is reached until it is freed.
    void plant(HexCoord root);
    const std::optional<HexCoord> &root() const { return root_; }
    /// Without a root; nothing is reached.
    void clear();

    /// Takes another occupancy of the same lattice in the place of the one before, and repairs the tree. Time: a pass
    /// over both occupancies' words, and what changes in the tree.
    /// @throws std::length_error if the lattice has another size
    void setOccupancy(std::shared_ptr<const Occupancy> occupancy);
    const std::shared_ptr<const Occupancy> &occupancy() const { return occupancy_; }

    /// Grows until the shortest path to the target is known, no cell is left, or stop() returns true; it is asked
    /// before the first expansion and after every `pollInterval` of them. An empty function never stops; a stopped tree
    /// goes on when asked again.
    /// @return Exhausted if there is no path: target or root is blocked, or outside, or they lie apart
    SearchStatus growTo(HexCoord target, const std::function<bool()> &stop = {}, std::uint64_t pollInterval = 4096);

    /// Length of the path to a cell, in pitches: the sum of its jumps' lengths. The least one for a cell that was found
    /// by growTo() since cells changed; for others that were reached, that of the path known. Infinite for the rest.
    double length(HexCoord cell) const;
    /// Its cells from the root on; empty if the cell was not reached.
    std::vector<CellIndex> path(HexCoord cell) const;

    const CellLayout &layout() const { return layout_; }
    /// Since plant().
    const SearchCounters &counters() const { return counters_; }
    /// Cells that repairs cut off, since plant().
    std::uint64_t cutOff() const { return cutOff_; }

private:
    using Label = std::uint64_t;  // length from the root in units, and the jump that led here
    static constexpr unsigned int jumpBits = 5;
    static constexpr Label jumpMask = (Label{1} << jumpBits) - 1;
    static constexpr std::size_t mostJumps = NormCones::mostJumps;

    bool isFreeCell(HexCoord cell) const;
    std::uint8_t arrivedBy(CellIndex cell) const { return static_cast<std::uint8_t>(store_.label(cell) & jumpMask); }
    std::int64_t lengthInUnits(CellIndex cell) const
    {
        return static_cast<std::int64_t>(store_.label(cell) >> jumpBits);
    }
    std::int64_t estimate(CellIndex cell) const;
    bool isKnown(CellIndex cell) const { return store_.isReached(cell) && estimate(cell) <= passed_; }

    void aimAt(HexCoord target);
    SearchStatus grow(CellIndex target, const std::function<bool()> &stop, std::uint64_t pollInterval);
    void expand(CellIndex cell, HexCoord left, std::int64_t estimate);
    const std::uint32_t *added(HexCoord left, std::uint32_t jumps);
    void reach(CellIndex cell, std::int64_t length, std::int64_t estimate, unsigned int jump);

    void repair();
    bool isArrivalValid(CellIndex cell) const;
    void joinElsewhereOrCutOff(CellIndex cell);
    void reopen(CellIndex cell);

    std::shared_ptr<const Occupancy> occupancy_;
    CellLayout layout_;
    HexJumps jumps_;
    HexWindow blocked_;
    LabelStoreOf<Label> store_;
    SpreadQueue open_;
    const NaturalJumps &natural_;
    units::RingNorm norm_;
    NormCones cones_;
    std::array<std::int64_t, mostJumps> lengths_;                // in units
    std::array<std::array<std::int32_t, mostJumps>, 2> deltas_;  // by parity and jump: index differences

    std::optional<HexCoord> root_;
    std::optional<HexCoord> aim_;  // the target of the keys of open_
    bool isOpenStale_ = true;      // open_ does not hold just the open cells
    std::int64_t passed_ = -1;     // an estimate up to which lengths are least
    std::int64_t leastReopened_;   // since aimAt()
    const NormCones::Cone *cone_ = nullptr;
    std::array<std::uint32_t, mostJumps> addedHere_;  // where no cone holds
    SearchCounters counters_;
    std::uint64_t cutOff_ = 0;

    // of setOccupancy(), empty otherwise
    CellSet near_;
    CellSet cut_;
    SpreadQueue loose_;  // by length from the root: cells whose arrival is no longer valid
};

}  // namespace seahex
