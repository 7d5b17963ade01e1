#include "CostHistory.h"

#include <algorithm>
#include <cmath>

namespace benchmark_planners
{

void CostHistory::add(double seconds, double cost)
{
    if (std::isfinite(seconds) && std::isfinite(cost))
        costs_.push_back({seconds, cost});
}

void CostHistory::finish(double seconds, double cost)
{
    for (TimedCost &claim : costs_)
        claim.cost = std::max(claim.cost, cost);
    add(seconds, cost);
}

std::vector<TimedCost> CostHistory::improvements() const
{
    std::vector<TimedCost> sorted = costs_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const TimedCost &a, const TimedCost &b) { return a.seconds < b.seconds; });
    std::vector<TimedCost> falling;
    for (const TimedCost &next : sorted)
    {
        if (!falling.empty() && next.cost >= falling.back().cost)
            continue;
        if (!falling.empty() && next.seconds == falling.back().seconds)
            falling.pop_back();
        falling.push_back(next);
    }
    return falling;
}

}  // namespace benchmark_planners
