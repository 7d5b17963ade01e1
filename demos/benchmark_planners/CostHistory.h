#pragma once

#include <vector>

namespace benchmark_planners
{

/// A cost and when in the run it was reached.
struct TimedCost
{
    double seconds;
    double cost;
};

/// How the cost of a run's best solution fell.
class CostHistory
{
public:
    /// Notes a cost as it was reported; what is not finite is left out.
    void add(double seconds, double cost);

    /// Notes the cost of the path that the run ended with, as measured on the path itself, and holds the reports
    /// against it: a lower cost that was claimed but not delivered counts as what was delivered.
    void finish(double seconds, double cost);

    void clear() { costs_.clear(); }
    bool empty() const { return costs_.empty(); }

    /// In the order of time, each lower than the one before.
    std::vector<TimedCost> improvements() const;

private:
    std::vector<TimedCost> costs_;
};

}  // namespace benchmark_planners
