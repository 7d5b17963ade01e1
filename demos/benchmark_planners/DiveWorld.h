#pragma once

#include "DiveJudge.h"
#include "World.h"
#include "common/DivePairs.h"

#include <seahex/chart/Projection.h>
#include <seahex/world/DiveArena.h>

#include <memory>
#include <string>
#include <vector>

namespace benchmark_planners
{

/// The water over a seabed: R^3.
class DiveWorld : public World
{
public:
    /// @param name  of the seabed, for people
    DiveWorld(std::string name, std::shared_ptr<const seahex::DiveArena> arena, const seahex::Projection &projection,
              std::vector<demos::DivePair> pairs);

    unsigned pairCount() const override { return static_cast<unsigned>(pairs_.size()); }
    PairFacts pair(unsigned number) const override;
    std::unique_ptr<ompl::geometric::SimpleSetup> makeSetup(unsigned pair) const override;
    std::shared_ptr<RecordedPlanner> makePlanner(const std::string &name, unsigned pair, std::uint32_t seed,
                                                 const ompl::base::SpaceInformationPtr &si) const override;

    /// Every sample of DiveJudge is free. A path with one that is not becomes "unsafe" in the run's properties.
    bool isSafe(const ompl::geometric::PathGeometric &path, ompl::tools::Benchmark::RunProperties &run) const override;

    /// Length in space, legs, changes of direction and their sum (up and down included), and the least water below the
    /// dive.
    double measure(const ompl::geometric::PathGeometric &path,
                   ompl::tools::Benchmark::RunProperties &run) const override;

    nlohmann::ordered_json description() const override;

private:
    std::string name_;
    std::shared_ptr<const seahex::DiveArena> arena_;
    seahex::Projection projection_;
    std::vector<demos::DivePair> pairs_;
    DiveJudge judge_;
};

}  // namespace benchmark_planners
