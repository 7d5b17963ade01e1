#pragma once

#include "Claims.h"
#include "Table.h"
#include "common/Progress.h"

#include <cstdint>
#include <string>
#include <vector>

namespace reproduce_papers
{

/// What to try the claims on.
struct ClaimsOptions
{
    std::vector<std::string> charts;
    unsigned pairs = 200;  ///< on each chart
    double cells = 22737;  ///< hexagons over each chart: as many as [Cheng2020] has
    std::uint32_t seed = 1;
    unsigned threads = 2;
};

/// The values of all claims on one chart.
struct ChartTrials
{
    std::string chart;
    double pitchM = 0.0;
    double leastDistance = 0.2;  ///< of a pair, as a share of the diagonal
    std::size_t cells = 0;
    unsigned leftOut = 0;  ///< pairs for which some lattice has no path
    std::vector<Trial> trials;
};

/// Tries all methods on random pairs in all headings on every chart. A chart whose water is too narrow for the cells
/// gets finer ones.
/// @throws demos::Failure if a chart can't be read or has no such pairs
std::vector<ChartTrials> runTrials(const ClaimsOptions &options, demos::Progress &progress);

/// The charts with their lattices, and each claim over all pairs: quartiles, the share of pairs for which it holds, and
/// on how many charts it holds in the median.
std::vector<Table> claimTables(const std::vector<ChartTrials> &charts);

/// The same for programs, chart by chart.
nlohmann::ordered_json claimsJson(const std::vector<ChartTrials> &charts);

}  // namespace reproduce_papers
