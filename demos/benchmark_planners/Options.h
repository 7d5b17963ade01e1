#pragma once

#include "common/ChartOptions.h"
#include "common/DiveOptions.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace benchmark_planners
{

/// A share of the jobs: those whose number, counted from 0, leaves index - 1 when divided by count.
struct Shard
{
    unsigned index = 1;
    unsigned count = 1;

    bool contains(std::size_t job) const { return job % count == index - 1; }
};

/// The command line, checked and with defaults filled in.
struct Options : demos::ChartOptions
{
    demos::DiveOptions dive;            ///< with a raster the planners dive over it, and there is no chart
    std::vector<std::string> planners;  ///< names of the world's roster, in its order
    unsigned pairs = 24;
    unsigned runs = 1;           ///< of every planner on every pair
    double timeS = 2.0;          ///< of one run
    double leastDistance = 0.3;  ///< of start and goal, as a share of the diagonal of the world's box
    std::uint32_t seed = 1;
    unsigned jobs = 1;           ///< at a time
    std::optional<Shard> shard;  ///< if empty, all jobs are run and the page is made
    std::filesystem::path out = "out/benchmark";
    std::optional<std::vector<std::string>> merge;  ///< folders to merge; nothing is run then
    bool json = false;
};

/// What came of reading the command line.
struct CommandLine
{
    std::optional<Options> options;  ///< empty: the text was asked for (help)
    std::string text;
};

/// @throws demos::Failure (Exit::Usage) with one sentence
CommandLine readCommandLine(int argc, const char *const *argv);

}  // namespace benchmark_planners
