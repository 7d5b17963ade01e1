#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>

namespace seahex
{

/// How far a planner has come, for other threads to read at any time. Each value is whole by itself; together they may
/// be of different moments.
struct ProgressBoard
{
    std::atomic<double> bestCost{0.0};
    std::atomic<double> lowerBound{0.0};
    std::atomic<std::uint64_t> expanded{0};
    std::atomic<std::uint64_t> open{0};

    void clear(double worst, double least)
    {
        bestCost = worst;
        lowerBound = least;
        expanded = 0;
        open = 0;
    }

    /// By the thread that plans. Sums rounded otherwise may bring a bound above the cost that it bounds.
    void raiseLowerBound(double bound) { lowerBound = std::max(lowerBound.load(), std::min(bound, bestCost.load())); }
};

}  // namespace seahex
