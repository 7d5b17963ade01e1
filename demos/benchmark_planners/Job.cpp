#include "Job.h"

#include "RecordedBenchmark.h"

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

void describePair(const World &world, unsigned number, ompl::tools::Benchmark &benchmark)
{
    const PairFacts pair = world.pair(number);
    const auto addReal = [&benchmark](const char *name, double value)
    {
        benchmark.addExperimentParameter(name, "REAL", logNumber(value));
    };
    benchmark.addExperimentParameter("pair", "INTEGER", std::to_string(number));
    addReal("course", pair.courseDeg);
    addReal("distance", pair.distanceM);
    addReal("start_latitude", pair.start.latitudeDeg());
    addReal("start_longitude", pair.start.longitudeDeg());
    addReal("goal_latitude", pair.goal.latitudeDeg());
    addReal("goal_longitude", pair.goal.longitudeDeg());
    if (!pair.dive)
        return;
    addReal("start_depth", pair.dive->startDepthM);
    addReal("goal_depth", pair.dive->goalDepthM);
    benchmark.addExperimentParameter("seabed_in_the_way", "BOOLEAN", pair.dive->isSeabedInTheWay ? "1" : "0");
}

}  // namespace

bool runJob(const World &world, const Job &job, const std::string &name, std::ostream &log)
{
    constexpr double memoryMb = 4096.0;
    constexpr double samplingS = 1.0;  // no RecordedPlanner has properties to sample
    constexpr double graceS = 1.0;     // RecordedPlanner keeps the limit; Benchmark's own is polled at 0.1 s
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const std::uint32_t seed = seedOf(job.seed, job.pair);
    ompl::RNG::setSeed(seed);

    const std::unique_ptr<og::SimpleSetup> setup = world.makeSetup(job.pair);
    RecordedBenchmark benchmark(*setup, name, RunJudge(world, *setup));
    describePair(world, job.pair, benchmark);
    for (const std::string &plannerName : job.planners)
    {
        const auto planner = world.makePlanner(plannerName, job.pair, seed, setup->getSpaceInformation());
        planner->setTimeLimit(job.timeS);
        benchmark.add(planner);
        setup->setPlanner(planner);  // without one, setup() would look for a default that aborts on R^2 (OMPL 1.5.2)
    }
    benchmark.benchmark({job.timeS + graceS, memoryMb, job.runs, samplingS, false, false, false});
    return benchmark.saveResultsToStream(log) && log.flush();
}

}  // namespace benchmark_planners
