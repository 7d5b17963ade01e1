#pragma once

#include <seahex/geometry/CellLayout.h>
#include <seahex/search/OpenList.h>
#include <seahex/search/SearchCounters.h>
#include <seahex/search/SearchMemory.h>
#include <seahex/search/SearchStatus.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace seahex
{

/// A* over any lattice [Hart1968].
///
/// The lattice is a class with these functions; cells are numbers below size():
///
///     std::size_t size() const
///     bool expand(CellIndex cell, std::uint8_t arrivedBy, Relax relax)
///         calls relax(successor, jump, cost) for every valid jump from the cell; jump < 255 names the way there;
///         false if it was interrupted and wants to be called again for the same cell
///     CellIndex predecessor(CellIndex cell, std::uint8_t jump) const
///     double bound(CellIndex cell) const
///         lower bound of the cost from the cell to a goal
///     bool sharpen(std::uint64_t expanded)
///         asked before each expansion, with the number of those before; true if bounds have grown since
///     double tie(CellIndex cell, double bound) const
///         among cells of equal estimate the smallest is expanded first
///     double finish(CellIndex cell) const
///         cost of ending in this cell; not better than worst() where it is no goal
///     double combine(double, double) const, bool better(double, double) const, double worst() const
///         the algebra of costs; for lengths: sum, less, infinity
///     bool improves(double cost, double known) const
///         better by more than rounding
///     double key(double estimate) const
///         the estimate, or a slightly better one that makes equal costs compare equal
///
/// Optimal if bound() never overestimates; where it is inconsistent, closed cells are reopened. Where it overestimates,
/// the path is valid but may not be the best.
///
/// Memory: 9 bytes for each cell that was touched (untouched pages stay untouched) and 2 bits for each other. Time of
/// reset() is that of clearing the bits.
template <class Lattice>
class AStar
{
public:
    /// In the place of a jump where a path begins.
    static constexpr std::uint8_t noJump = 255;

    /// Does not own the lattice, which must outlive the search.
    explicit AStar(Lattice &lattice)
        : lattice_(lattice), open_(Before{&lattice}), cost_(new double[lattice.size()]),
          arrivedBy_(new std::uint8_t[lattice.size()]), generated_((lattice.size() + 63) / 64),
          closed_((lattice.size() + 63) / 64), bestCost_(lattice.worst())
    {
    }

    /// A cell from which the path may begin, and what it costs to get there.
    void addStart(CellIndex cell, double cost) { relax(cell, noJump, cost); }

    /// Goes on until a best path is found, no cell is left, or stop() returns true. stop() is asked before the first
    /// expansion and after every `pollInterval` of them.
    // Flattened: whether the compiler inlines the inner loop must not depend on what else is in the file.
    template <class Stop>
    [[gnu::flatten]] SearchStatus run(Stop &&stop, std::uint64_t pollInterval)
    {
        std::uint64_t untilPoll = 0;
        while (interrupted_ || !open_.empty())
        {
            // compared as keys: what is left may still be better by the rounding of key(), which is none for the user
            if (!interrupted_ && bestGoal_ && !lattice_.better(open_.top().key, lattice_.key(bestCost_)))
                return SearchStatus::Found;
            if (untilPoll-- == 0)
            {
                if (stop())
                    return SearchStatus::Stopped;
                untilPoll = pollInterval - 1;
            }
            if (!interrupted_ && lattice_.sharpen(counters_.expanded))
            {
                renewKeys();
                continue;  // with whatever is first now, if anything is left
            }
            const OpenEntry entry = takeNext();
            if (!testBit(closed_, entry.cell) && !expand(entry))
                return SearchStatus::Stopped;
        }
        return bestGoal_ ? SearchStatus::Found : SearchStatus::Exhausted;
    }

    /// Cost of the best path so far, its finish included; worst() if there is none.
    double cost() const { return bestCost_; }
    bool hasPath() const { return bestGoal_.has_value(); }

    /// The key of the cell that is next: no path that is still to be found has a smaller one, if the bound is
    /// admissible. That of the best path where it is as good; that of worst() where nothing is left.
    double leastKey() const
    {
        const double best = lattice_.key(bestCost_);
        if (interrupted_)
            return lattice_.better(best, interrupted_->key) ? best : interrupted_->key;
        return open_.empty() || lattice_.better(best, open_.top().key) ? best : open_.top().key;
    }

    /// Entries of the open list, outdated ones included.
    std::size_t openSize() const { return open_.size(); }

    /// The cells of the best path so far, from a start to a goal; empty if there is none.
    std::vector<CellIndex> path() const { return bestGoal_ ? pathTo(*bestGoal_) : std::vector<CellIndex>(); }

    /// The cells of the best path known from a start to a cell that was reached.
    std::vector<CellIndex> pathTo(CellIndex cell) const
    {
        std::vector<CellIndex> cells = {cell};
        for (; arrivedBy_[cell] != noJump; cells.push_back(cell))
            cell = lattice_.predecessor(cell, arrivedBy_[cell]);
        std::reverse(cells.begin(), cells.end());
        return cells;
    }

    /// Cost of the best path known to a cell that was reached, and the jump that ends it; noJump where it begins.
    double costOf(CellIndex cell) const { return cost_[cell]; }
    std::uint8_t arrivedBy(CellIndex cell) const { return arrivedBy_[cell]; }

    /// True if a path to the cell is known.
    bool isReached(CellIndex cell) const { return testBit(generated_, cell); }

    /// Calls visit(cell, arrivedBy, isExpanded) for every cell that was reached, in the order of cells; arrivedBy is
    /// the jump of the best path known to it, or noJump where that path begins.
    template <class Visit>
    void forEachReached(Visit &&visit) const
    {
        for (std::size_t word = 0; word < generated_.size(); ++word)
        {
            if (generated_[word] == 0)
                continue;
            for (unsigned int bit = 0; bit < 64; ++bit)
                if ((generated_[word] >> bit) & 1)
                {
                    const auto cell = static_cast<CellIndex>(word * 64 + bit);
                    visit(cell, arrivedBy_[cell], testBit(closed_, cell));
                }
        }
    }

    const SearchCounters &counters() const { return counters_; }

    SearchMemory memory() const
    {
        return {(generated_.capacity() + closed_.capacity()) * sizeof(std::uint64_t),
                static_cast<std::size_t>(counters_.generated) * (sizeof(double) + sizeof(std::uint8_t)) +
                    open_.capacityBytes()};
    }

    /// If given, every expanded cell is appended to the trace in the order of expansion.
    void setTrace(std::vector<CellIndex> *trace) { trace_ = trace; }

    /// Forgets everything but the lattice, whose bounds stay as sharp as they are; keeps the memory.
    void reset()
    {
        open_.clear();
        interrupted_.reset();
        std::fill(generated_.begin(), generated_.end(), 0);
        std::fill(closed_.begin(), closed_.end(), 0);
        bestGoal_.reset();
        bestCost_ = lattice_.worst();
        counters_ = {};
    }

private:
    struct Before
    {
        const Lattice *lattice;
        bool operator()(const OpenEntry &a, const OpenEntry &b) const
        {
            if (lattice->better(a.key, b.key))
                return true;
            return !lattice->better(b.key, a.key) && a.tie < b.tie;
        }
    };

    static bool testBit(const std::vector<std::uint64_t> &bits, CellIndex i) { return (bits[i >> 6] >> (i & 63)) & 1; }
    static void setBit(std::vector<std::uint64_t> &bits, CellIndex i) { bits[i >> 6] |= std::uint64_t{1} << (i & 63); }
    static void clearBit(std::vector<std::uint64_t> &bits, CellIndex i)
    {
        bits[i >> 6] &= ~(std::uint64_t{1} << (i & 63));
    }

    OpenEntry takeNext()
    {
        if (interrupted_)
        {
            const OpenEntry entry = *interrupted_;
            interrupted_.reset();
            return entry;
        }
        const OpenEntry entry = open_.top();
        open_.pop();
        return entry;
    }

    /// Puts the open list in order again. What was expanded stays so: with a consistent bound its cost is final.
    void renewKeys()
    {
        open_.renew(
            [this](OpenEntry &entry)
            {
                entry = entryOf(entry.cell);
                return !testBit(closed_, entry.cell);
            });
    }

    OpenEntry entryOf(CellIndex cell) const
    {
        const double bound = lattice_.bound(cell);
        return {lattice_.key(lattice_.combine(cost_[cell], bound)), lattice_.tie(cell, bound), cell};
    }

    bool expand(const OpenEntry &entry)
    {
        const CellIndex cell = entry.cell;
        const double cost = cost_[cell];
        setBit(closed_, cell);
        const bool finished = lattice_.expand(cell, arrivedBy_[cell],
                                              [this, cost](CellIndex successor, std::uint8_t jump, double jumpCost)
                                              { relax(successor, jump, lattice_.combine(cost, jumpCost)); });
        if (!finished)
        {
            // what was relaxed already stays; the cell is the next one again, so that the order stays the same
            clearBit(closed_, cell);
            interrupted_ = entry;
            return false;
        }
        ++counters_.expanded;
        if (trace_ != nullptr)
            trace_->push_back(cell);
        const double finish = lattice_.finish(cell);
        if (lattice_.better(finish, lattice_.worst()))
        {
            const double total = lattice_.combine(cost, finish);
            if (!bestGoal_ || lattice_.better(total, bestCost_))
            {
                bestGoal_ = cell;
                bestCost_ = total;
            }
        }
        return true;
    }

    void relax(CellIndex cell, std::uint8_t jump, double cost)
    {
        if (testBit(generated_, cell))
        {
            if (!lattice_.improves(cost, cost_[cell]))
                return;
            ++counters_.improved;
            if (testBit(closed_, cell))
            {
                ++counters_.reopened;
                clearBit(closed_, cell);
            }
        }
        else
        {
            setBit(generated_, cell);
            ++counters_.generated;
        }
        cost_[cell] = cost;
        arrivedBy_[cell] = jump;
        open_.push(entryOf(cell));
    }

    Lattice &lattice_;
    OpenList<Before> open_;
    std::optional<OpenEntry> interrupted_;  // its expansion was
    std::unique_ptr<double[]> cost_;
    std::unique_ptr<std::uint8_t[]> arrivedBy_;
    std::vector<std::uint64_t> generated_;
    std::vector<std::uint64_t> closed_;
    std::optional<CellIndex> bestGoal_;
    double bestCost_;
    SearchCounters counters_;
    std::vector<CellIndex> *trace_ = nullptr;
};

}  // namespace seahex
