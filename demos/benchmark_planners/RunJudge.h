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

    /// Adds to a run's properties: whether the path is valid (from the start to the goal, every leg safe to the world
    /// and valid to the problem); of a valid path the world's measures.
    /// @return the length in metres, which is the cost; empty if there is no exact solution or it is not valid
    std::optional<double> judge(ompl::tools::Benchmark::RunProperties &run) const;

private:
    bool isWhole(const ompl::geometric::PathGeometric &path) const;

    const World &world_;
    const ompl::geometric::SimpleSetup &setup_;
};

}  // namespace benchmark_planners
