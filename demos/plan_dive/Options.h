#pragma once

#include "common/DiveCatalogue.h"
#include "common/DiveOptions.h"

#include <seahex/chart/ChartBathymetry.h>
#include <seahex/geometry/GeoPoint.h>

#include <optional>
#include <string>
#include <vector>

namespace plan_dive
{

/// A position in the water.
struct DivePosition
{
    seahex::GeoPoint place = seahex::GeoPoint::fromLatLon(0.0, 0.0);
    double depthM = 0.0;
};

/// The command line, checked and with defaults filled in. With no raster the seabed is the charts'.
struct Options : demos::DiveOptions
{
    std::vector<std::string> charts;
    double spacingM = 0.0;  ///< of the charts' cells; 0: automatic
    seahex::ChartDepths chartDepths = seahex::ChartDepths::Least;
    double marginM = 0.0;  ///< least distance to what stands in the charts' water
    /// Cables are crossed above, with so much more than the clearance; empty: they are columns to keep out of.
    std::optional<double> crossCablesM;
    DivePosition from;
    DivePosition to;
    std::string planner = "LayeredPlanner";
    demos::DivePlannerSettings settings;  ///< a vehicle's length of 0: the distance between slices
    double timeS = 10.0;
    std::string out;
    std::string profile;
    std::string picture;
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

}  // namespace plan_dive
