#pragma once

#include <atomic>
#include <cstdint>

namespace seahex
{

/// How far a planner on slices has come, for other threads to read at any time.
struct SliceProgress
{
    std::atomic<double> bestCost{0.0};
    std::atomic<std::uint64_t> points{0};  ///< that the checker was asked for
    std::atomic<std::uint64_t> legs{0};    ///< that the motion validator was asked for

    void clear(double worst)
    {
        bestCost = worst;
        points = 0;
        legs = 0;
    }
};

}  // namespace seahex
