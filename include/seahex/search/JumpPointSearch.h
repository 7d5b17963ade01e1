#pragma once

#include <seahex/search/HexRays.h>
#include <seahex/search/LabelStore.h>
#include <seahex/search/SearchCounters.h>
#include <seahex/search/SearchMemory.h>
#include <seahex/search/SearchStatus.h>
#include <seahex/world/Occupancy.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace seahex
{

/// The shortest chain of steps to neighbours from one cell of an occupancy of hexagons to another: jump point search,
/// [Harabor2011] carried over from squares.
///
/// The six directions fall into two classes, in turns around the compass: *rays* (east, north-west, south-west; see
/// HexRays) and *leads* (north-east, west, south-east). Of all shortest paths those are looked for which make their
/// leading steps first. In what directions a path goes on from a cell x that it has reached
/// - by a lead d: in d, and in the two rays 60 degrees off it;
/// - by a ray e: in e; and in a lead 60 degrees off e, if x's neighbour 120 degrees off e on the same side is blocked
///   (then x is a turn of HexRays);
/// - at the start: in all six.
///
/// Why nothing is lost. Let p be the cell before x, and f a direction that is not gone on in; y = x + f. If f is 120 or
/// 180 degrees off the last step, then y is p's neighbour or p itself, and a path by x is none of the shortest to y. So
/// f is a lead 60 degrees off a ray e, and p + f, x's neighbour 120 degrees off e, is free: p, p + f, y is as long, and
/// its last step is a ray. Now say that every cell nearer to the start than y is gone on from, by one of its shortest
/// arrivals at least, whichever. Among the last steps of shortest paths to y take a ray if there is one, else a lead.
/// Were it not gone on in, it would be a lead, and another shortest path to y would end with a ray. So y is reached by
/// a shortest path too. It follows that of several equally short arrivals at a cell one is enough: a scan ends wherever
/// a cell has a label that is no larger.
///
/// From a ray's cells that are no turns nothing but the ray itself goes on, so that they need not be looked at one by
/// one: labels are given to turns, and to the cells of a lead, from each of which two rays are sent out. A lead goes on
/// only as long as its estimate is the least of all; the rest of it waits in the open list.
///
/// Costs are whole numbers, the bound is the number of steps in open water, and the open list a stack for every
/// estimate. The search ends when the goal has the least estimate.
///
/// Memory: that of LabelStore and HexRays, and 24 bytes for each cell that was put in the open list. A second search
/// uses the memory of the first, and clearing takes time by what was touched.
class JumpPointSearch
{
public:
    /// @param occupancy  of hexagons; must outlive the search
    /// @param rays  those of this occupancy, if they are to be shared; else they are made
    /// @throws std::length_error for more than 2^27 columns or rows
    explicit JumpPointSearch(const Occupancy &occupancy, std::shared_ptr<const HexRays> rays = nullptr);

    /// Takes 4 bytes a cell from the system now, not page by page during the first searches, which makes them slower.
    void takeMemory() { store_.takeMemory(); }

    /// Forgets the last search and prepares one between two cells of the occupancy, both free.
    void begin(HexCoord start, HexCoord goal);

    /// Goes on until the shortest path is found, no cell is left, or stop() returns true; it is asked before the first
    /// expansion and after every `pollInterval` of them. An empty function never stops.
    SearchStatus run(const std::function<bool()> &stop = {}, std::uint64_t pollInterval = 4096);

    bool hasPath() const { return goalNode_.has_value(); }
    /// Length of the shortest path, in pitches: its number of steps; infinite if none is known.
    double cost() const;
    /// Its cells from start to goal, each next to the one before; empty if there is none.
    std::vector<CellIndex> path() const;

    /// No path that is still to be found is shorter than this, in pitches.
    double lowerBound() const;

    const CellLayout &layout() const { return layout_; }
    /// Expanded are turns, and the parts of leads that were taken from the open list; generated, improved: labels.
    const SearchCounters &counters() const { return counters_; }
    /// Looks at 64 cells of a ray.
    std::uint64_t scannedWords() const { return scannedWords_; }
    /// Cells of leads, from each of which two rays were sent out.
    std::uint64_t leadCells() const { return leadCells_; }
    std::size_t openSize() const { return openSize_; }
    /// For further searches on the same occupancy, in other threads too.
    const std::shared_ptr<const HexRays> &rays() const { return rays_; }
    SearchMemory memory() const;

    /// Has the cell a label?
    bool isReached(CellIndex cell) const { return store_.isReached(cell); }

    /// If given, the cell of every expansion is appended to the trace.
    void setTrace(std::vector<CellIndex> *trace) { trace_ = trace; }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// What is gone on with at a cell: kinds 0 to 2, a ray that came to a turn; 3 to 5, a lead; 6, the start.
    enum Kind : std::uint32_t
    {
        firstLead = 3,
        atStart = 6
    };

    /// In the open list, or taken from it; kept for the path.
    struct Node
    {
        std::int32_t q;
        std::int32_t s;
        std::uint32_t cost;
        std::uint32_t parent;
        std::uint32_t below;  // in its stack
        std::uint32_t kind;
    };

    CellIndex indexOf(std::int32_t q, std::int32_t s) const
    {
        return static_cast<CellIndex>((s + CellLayout::frame) * layout_.stride() + q + (s + (s & 1)) / 2 +
                                      CellLayout::frame);
    }
    std::uint32_t remaining(std::int32_t q, std::int32_t s) const
    {
        const std::int32_t dq = goalQ_ - q;
        const std::int32_t ds = goalS_ - s;
        return static_cast<std::uint32_t>((std::abs(dq) + std::abs(ds) + std::abs(dq + ds)) / 2);
    }
    bool isBlocked(std::int32_t q, std::int32_t s) const
    {
        const CellIndex cell = indexOf(q, s);
        return (blocked_[cell >> 6] >> (cell & 63)) & 1;
    }

    bool improves(CellIndex cell, std::uint32_t cost);
    void push(std::uint32_t estimate, const Node &node);
    void expand(std::uint32_t index);
    void followLead(unsigned int lead, std::int32_t q, std::int32_t s, std::uint32_t cost, std::uint32_t parent);
    template <unsigned int lead>
    void followLead(std::int32_t q, std::int32_t s, std::uint32_t cost, std::uint32_t parent);
    template <unsigned int ray>
    void sendRay(HexRays::Address from, std::int32_t q, std::int32_t s, std::uint32_t cost, std::uint32_t parent);

    CellLayout layout_;
    const std::uint64_t *blocked_;
    std::shared_ptr<const HexRays> rays_;
    LabelStore store_;
    std::array<std::array<HexRays::Address, 2>, 3> leadDeltas_;  // of a lead in the planes of the rays beside it

    // of one search
    std::int32_t goalQ_ = 0;
    std::int32_t goalS_ = 0;
    std::array<HexRays::Address, HexRays::directions> goalAddress_;
    std::uint32_t startBound_ = 0;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> stacks_;  // by estimate, from startBound_ on: the uppermost node
    std::size_t current_ = 0;            // of stacks_
    std::size_t openSize_ = 0;
    std::optional<std::uint32_t> goalNode_;
    std::uint64_t scannedWords_ = 0;
    std::uint64_t leadCells_ = 0;
    SearchCounters counters_;
    std::vector<CellIndex> *trace_ = nullptr;
};

}  // namespace seahex
