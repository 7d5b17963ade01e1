#pragma once

#include "World.h"
#include "common/Pairs.h"

#include <seahex/chart/Chart.h>
#include <seahex/chart/ChartArena.h>
#include <seahex/chart/WrittenRouteCheck.h>

#include <memory>
#include <vector>

namespace benchmark_planners
{

/// The plane of a chart: R^2, hexagonal cells.
class ChartWorld : public World
{
public:
    ChartWorld(std::shared_ptr<const seahex::Chart> chart, std::shared_ptr<const seahex::ChartArena> arena,
               std::vector<demos::Pair> pairs = {});

    const seahex::ChartArena &arena() const { return *arena_; }

    unsigned pairCount() const override { return static_cast<unsigned>(pairs_.size()); }
    PairFacts pair(unsigned number) const override;
    std::unique_ptr<ompl::geometric::SimpleSetup> makeSetup(unsigned pair) const override;
    std::shared_ptr<RecordedPlanner> makePlanner(const std::string &name, unsigned pair, std::uint32_t seed,
                                                 const ompl::base::SpaceInformationPtr &si) const override;

    /// Every leg lies on free cells only.
    bool isSafe(const ompl::geometric::PathGeometric &path, ompl::tools::Benchmark::RunProperties &run) const override;

    /// Length in the plane, legs, turns and turn angle as RouteMetrics defines them, and the least distance from the
    /// whole line to the geometry of a hazard.
    double measure(const ompl::geometric::PathGeometric &path,
                   ompl::tools::Benchmark::RunProperties &run) const override;

    nlohmann::ordered_json description() const override;

private:
    std::shared_ptr<const seahex::Chart> chart_;
    std::shared_ptr<const seahex::ChartArena> arena_;
    seahex::WrittenRouteCheck check_;
    std::vector<demos::Pair> pairs_;
};

}  // namespace benchmark_planners
