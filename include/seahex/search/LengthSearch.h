#pragma once

#include <seahex/geometry/HexWindow.h>
#include <seahex/search/BucketQueue.h>
#include <seahex/search/HexJumps.h>
#include <seahex/search/LabelStore.h>
#include <seahex/search/NaturalJumps.h>
#include <seahex/search/NormCones.h>
#include <seahex/search/SearchCounters.h>
#include <seahex/search/SearchMemory.h>
#include <seahex/search/SearchStatus.h>
#include <seahex/search/UnitLengths.h>
#include <seahex/world/Occupancy.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace seahex
{

/// The shortest chain of ring jumps from one cell to another, fast: A* for this one purpose, where AStar serves any.
///
/// What is searched: cells of an occupancy of hexagons; a jump is valid if every cell that it touches is free; its cost
/// is its length. Lengths are whole numbers (UnitLengths.h), so costs are exact to 4e-9 of themselves and equal costs
/// are equal. The bound is the ring's own norm, exact in open water and consistent.
///
/// How it is fast:
/// - Edges: the blocked cells around a cell are gathered into one number; a jump is tested by one AND (HexWindow).
/// - Successors: jumps that a path avoiding the cell makes no later are not tried, by the jump that led there; why that
///   is lossless stands in NaturalJumps.
/// - Estimates: what a jump adds to the estimate is looked up, once per expansion, by the cone in which the goal lies
///   (NormCones). A label keeps the estimate, modulo 2^27 units, and the jump that led there; only differences count,
///   and labels of open cells differ by a few pitches.
/// - Order: a BucketQueue. Within a bucket, a 36th of a pitch, a cell may be expanded before its best label is known;
/// it
///   is expanded again then. The path is the shortest all the same: a goal counts when its bucket is done.
///
/// Memory: that of LabelStore, and 4 bytes for each open cell. Nothing is allocated in the loop but for the growth of
/// lists; a second search uses the memory of the first, and clearing takes time by what was touched.
class LengthSearch
{
public:
    /// In the place of a jump where the path begins.
    static constexpr std::uint8_t noJump = NaturalJumps::start;

    /// @param occupancy  of hexagons; must outlive the search
    /// @param rings  1, 2 or 3
    /// @throws std::length_error for more than 2^27 columns or rows
    LengthSearch(const Occupancy &occupancy, int rings);

    /// Uses other rings from the next begin() on.
    void useRings(int rings);

    /// Forgets the last search: no cell is reached.
    void forget();

    /// Forgets the last search and prepares one between two cells of the occupancy.
    void begin(HexCoord start, HexCoord goal);

    /// Goes on until the shortest path is found, no cell is left, or stop() returns true; it is asked before the first
    /// expansion and after every `pollInterval` of them. An empty function never stops.
    SearchStatus run(const std::function<bool()> &stop = {}, std::uint64_t pollInterval = 4096);

    bool hasPath() const { return bestGoal_.has_value(); }
    /// Length of the best path so far, in pitches: the sum of its jumps' lengths; infinite if there is none.
    double cost() const;
    /// Its cells from start to goal; empty if there is none.
    std::vector<CellIndex> path() const { return hasPath() ? pathTo(goal_) : std::vector<CellIndex>(); }
    /// The cells of the best path known to a cell that was reached.
    std::vector<CellIndex> pathTo(CellIndex cell) const;

    /// No path that is still to be found is shorter than this, in pitches.
    double lowerBound() const;

    const CellLayout &layout() const { return layout_; }
    const HexJumps &jumps() const { return jumps_; }
    const SearchCounters &counters() const { return counters_; }
    std::size_t openSize() const { return open_.size(); }
    SearchMemory memory() const
    {
        return {2 * store_.size() / 8, static_cast<std::size_t>(counters_.generated) * sizeof(std::uint32_t) +
                                           store_.touchedWords().capacity() * sizeof(std::uint32_t) + open_.bytes()};
    }

    bool isReached(CellIndex cell) const { return store_.isReached(cell); }
    /// The jump of the best path known to a cell that was reached; noJump where it begins.
    std::uint8_t arrivedBy(CellIndex cell) const { return store_.label(cell) & jumpMask; }

    /// Calls visit(cell, arrivedBy, isExpanded) for every cell that was reached.
    template <class Visit>
    void forEachReached(Visit &&visit) const
    {
        for (const std::uint32_t word : store_.touchedWords())
            for (std::uint64_t bits = store_.reachedWord(word); bits != 0; bits &= bits - 1)
            {
                const CellIndex cell = 64 * word + static_cast<CellIndex>(__builtin_ctzll(bits));
                visit(cell, arrivedBy(cell), store_.isExpanded(cell));
            }
    }

    /// If given, every expanded cell is appended to the trace in the order of expansion.
    void setTrace(std::vector<CellIndex> *trace) { trace_ = trace; }

private:
    static constexpr std::uint32_t jumpBits = 5;
    static constexpr std::uint32_t jumpMask = (1U << jumpBits) - 1;
    static constexpr std::size_t mostJumps = NormCones::mostJumps;

    /// Where a cell lies: the parity of its row, and from it to the goal in cube coordinates.
    struct Place
    {
        unsigned int parity;
        std::int32_t q;
        std::int32_t s;
    };

    Place placeOf(CellIndex cell) const;
    bool isBeatenByGoal(CellIndex cell) const;
    void expand(CellIndex cell);
    void reach(CellIndex cell, std::uint32_t estimate, unsigned int jump);
    const std::uint32_t *added(const Place &place, std::uint32_t jumps);

    CellLayout layout_;
    HexJumps jumps_;  // of three rings: those of fewer come first
    HexWindow blocked_;
    LabelStore store_;
    BucketQueue open_;

    // of the rings in use
    const NaturalJumps *natural_;
    units::RingNorm norm_;
    NormCones cones_;
    int rings_;

    std::array<std::array<std::int32_t, mostJumps>, 2> deltas_;  // by parity and jump: index differences
    std::array<std::int32_t, mostJumps> jumpQ_;
    std::array<std::int32_t, mostJumps> jumpS_;
    std::uint64_t rowReciprocal_;
    unsigned int rowShift_;

    // of one search
    CellIndex goal_ = 0;
    std::int32_t goalQ_ = 0;
    std::int32_t goalS_ = 0;
    const NormCones::Cone *cone_ = nullptr;
    std::array<std::uint32_t, mostJumps> addedHere_;  // where no cone holds
    std::optional<std::uint32_t> bestGoal_;           // its estimate
    std::int64_t startBound_ = 0;
    std::uint64_t bucketsPassed_ = 0;
    SearchCounters counters_;
    std::vector<CellIndex> *trace_ = nullptr;
};

}  // namespace seahex
