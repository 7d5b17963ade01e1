#pragma once

#include "World.h"

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace benchmark_planners
{

/// One tools::Benchmark: some planners on one pair.
struct Job
{
    unsigned pair = 1;  ///< its number in the world
    std::vector<std::string> planners;
    unsigned runs = 1;
    double timeS = 1.0;
    std::uint32_t seed = 1;
};

/// Runs a job and writes its log. To be called once in a process, and before anything else has asked OMPL for random
/// numbers: their seed, made of the job's seed and the pair, can be set only once.
/// @return false if the log can't be written
bool runJob(const World &world, const Job &job, const std::string &name, std::ostream &log);

}  // namespace benchmark_planners
