#pragma once

#include "RecordedPlanner.h"

#include <nlohmann/json.hpp>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/tools/benchmark/Benchmark.h>
#include <seahex/geometry/GeoPoint.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace benchmark_planners
{

/// Of a pair in the water column.
struct DiveFacts
{
    double startDepthM;
    double goalDepthM;
    bool isSeabedInTheWay;  ///< of the straight line
};

/// What is told of a pair.
struct PairFacts
{
    seahex::GeoPoint start;
    seahex::GeoPoint goal;
    double courseDeg;
    double distanceM;  ///< over ground
    std::optional<DiveFacts> dive = std::nullopt;
};

/// Where planners are compared, with the pairs between which they plan. What all jobs share, made once and only read
/// from then on. Pairs are numbered from 1.
class World
{
public:
    virtual ~World() = default;

    virtual unsigned pairCount() const = 0;
    virtual PairFacts pair(unsigned number) const = 0;

    /// The problem of a pair, without a planner.
    virtual std::unique_ptr<ompl::geometric::SimpleSetup> makeSetup(unsigned pair) const = 0;

    /// A new planner of this world's roster.
    /// @param seed  of what has a generator of its own
    /// @throws std::out_of_range for a name that is not in the roster
    virtual std::shared_ptr<RecordedPlanner> makePlanner(const std::string &name, unsigned pair, std::uint32_t seed,
                                                         const ompl::base::SpaceInformationPtr &si) const = 0;

    /// Looks at every leg of a path of two states or more without asking the problem's own checkers, and may add to the
    /// run's properties what it sees.
    virtual bool isSafe(const ompl::geometric::PathGeometric &path,
                        ompl::tools::Benchmark::RunProperties &run) const = 0;

    /// Adds the measures of a safe path to a run's properties.
    /// @return its length in metres, which is the cost
    virtual double measure(const ompl::geometric::PathGeometric &path,
                           ompl::tools::Benchmark::RunProperties &run) const = 0;

    /// All of the world that decides results, for the manifest: a fingerprint instead of every number.
    virtual nlohmann::ordered_json description() const = 0;
};

/// A number for a log: twelve digits.
std::string logNumber(double value);

/// To a millionth, as it is written into manifests.
double toMillionths(double value);

}  // namespace benchmark_planners
