#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace seahex::contest
{

/// What to run. Beside these the program takes Google Benchmark's own options.
struct Options
{
    std::vector<std::string> worlds = {"S", "P", "N"};  ///< --worlds=S,P,archipelago:1e5
    std::size_t queries = 20;                           ///< --queries=20, on each world
    std::int64_t passes = 3;                            ///< --passes=3: the least time of each query counts
    /// --figures=FILE, any number of times: what instructions.sh and seahex_curves left, for the verdicts.
    std::vector<std::string> figures;
    std::size_t runs = 3;    ///< --runs=3, of each planner and query (seahex_curves)
    double limitS = 10.0;    ///< --limit=10, seconds a run (seahex_curves)
    std::uint64_t seed = 1;  ///< --seed=1, of the queries
};

/// @throws std::runtime_error for what is no option, or no value of it
Options readOptions(const std::vector<std::string> &arguments);

}  // namespace seahex::contest
