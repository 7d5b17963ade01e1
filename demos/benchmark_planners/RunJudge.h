#pragma once

#include "World.h"

#include <ompl/geometric/SimpleSetup.h>
#include <ompl/tools/benchmark/Benchmark.h>

#include <optional>

namespace benchmark_planners
{

/// Looks at the path a run ended with, for itself: OMPL's own run properties take the mean clearance of the vertices
/// and a smoothness that depends on their number.
class RunJudge
{
public:
    RunJudge(const World &world, const ompl::geometric::SimpleSetup &setup) : world_(world), setup_(setup) {}

    /// Adds to a run's properties: whether the path is valid (from the start to the goal, every leg on free cells
    /// only); of a valid path its length in the plane, legs, turns and turn angle as RouteMetrics defines them, and the
    /// least distance from the whole line to the geometry of a hazard.
    /// @return the length in metres, which is the cost; empty if there is no exact solution or it is not valid
    std::optional<double> judge(ompl::tools::Benchmark::RunProperties &run) const;

private:
    bool isValid(const ompl::geometric::PathGeometric &path) const;

    const World &world_;
    const ompl::geometric::SimpleSetup &setup_;
};

/// A number for a log: twelve digits.
std::string logNumber(double value);

}  // namespace benchmark_planners
