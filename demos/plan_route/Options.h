#pragma once

#include "common/ChartOptions.h"

#include <seahex/geometry/GeoPoint.h>
#include <seahex/search/Guidance.h>
#include <seahex/search/LengthWeight.h>

#include <cstdint>
#include <optional>
#include <string>

namespace plan_route
{

/// The command line, checked and with defaults filled in.
struct Options : demos::ChartOptions
{
    seahex::GeoPoint from = seahex::GeoPoint::fromLatLon(0.0, 0.0);
    seahex::GeoPoint to = seahex::GeoPoint::fromLatLon(0.0, 0.0);
    int rings = 3;
    seahex::Guidance guidance = seahex::Guidance::Automatic;
    seahex::LengthMetric metric = seahex::LengthMetric::Euclidean;
    std::string planner = "HexAStar";
    double timeS = 10.0;
    std::uint32_t seed = 1;
    bool smoothing = true;
    bool exact = true;  ///< smoothed to the shortest route of all, not only pulled taut
    std::string cells;  ///< the file to keep them in; empty: none
    std::string out;
    bool blockedCells = false;
    std::string picture;
    bool json = false;
    bool chengScenario = false;
};

/// What came of reading the command line.
struct CommandLine
{
    std::optional<Options> options;  ///< empty: the text was asked for (help, version)
    std::string text;
};

/// @throws demos::Failure (Exit::Usage) with one sentence
CommandLine readCommandLine(int argc, const char *const *argv);

}  // namespace plan_route
