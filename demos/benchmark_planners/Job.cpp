#include "Job.h"

#include "RecordedBenchmark.h"
#include "Roster.h"

#include <seahex/planning/Setup.h>

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

namespace og = ompl::geometric;

namespace benchmark_planners
{
namespace
{

/// The finaliser of MurmurHash3 over both numbers; never 0, which OMPL takes for "none".
std::uint32_t seedOf(std::uint32_t seed, unsigned pair)
{
    std::uint32_t h = seed * 0x9e3779b9U + pair;
    h = (h ^ (h >> 16)) * 0x85ebca6bU;
    h = (h ^ (h >> 13)) * 0xc2b2ae35U;
    h ^= h >> 16;
    return h == 0 ? 1 : h;
}

void describePair(const World &world, const demos::Pair &pair, ompl::tools::Benchmark &benchmark)
{
    const seahex::GeoPoint start = world.arena->projection().inverse(pair.start);
    const seahex::GeoPoint goal = world.arena->projection().inverse(pair.goal);
    const auto addReal = [&benchmark](const char *name, double value)
    {
        benchmark.addExperimentParameter(name, "REAL", logNumber(value));
    };
    benchmark.addExperimentParameter("pair", "INTEGER", std::to_string(pair.number));
    addReal("course", pair.courseDeg());
    addReal("distance", pair.distance());
    addReal("start_latitude", start.latitudeDeg());
    addReal("start_longitude", start.longitudeDeg());
    addReal("goal_latitude", goal.latitudeDeg());
    addReal("goal_longitude", goal.longitudeDeg());
}

}  // namespace

bool runJob(const World &world, const Job &job, const std::string &name, std::ostream &log)
{
    constexpr double memoryMb = 4096.0;
    constexpr double samplingS = 1.0;  // no RecordedPlanner has properties to sample
    constexpr double graceS = 1.0;     // RecordedPlanner keeps the limit; Benchmark's own is polled at 0.1 s
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(seedOf(job.seed, job.pair.number));

    const auto &occupancy = world.arena->occupancy();
    og::SimpleSetup setup(seahex::planarSpace(*occupancy));
    seahex::useOccupancy(setup, occupancy);
    seahex::setStartAndGoal(setup, job.pair.start, job.pair.goal);
    RecordedBenchmark benchmark(setup, name, RunJudge(world, setup));
    describePair(world, job.pair, benchmark);
    for (const std::string &plannerName : job.planners)
    {
        const auto planner = makeFromRoster(plannerName, setup.getSpaceInformation());
        planner->setTimeLimit(job.timeS);
        benchmark.add(planner);
        setup.setPlanner(planner);  // without one, setup() would look for a default that aborts on R^2 (OMPL 1.5.2)
    }
    benchmark.benchmark({job.timeS + graceS, memoryMb, job.runs, samplingS, false, false, false});
    return benchmark.saveResultsToStream(log) && log.flush();
}

}  // namespace benchmark_planners
