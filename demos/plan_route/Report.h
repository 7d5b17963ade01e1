#pragma once

#include "Job.h"
#include "Options.h"

#include <string>

namespace plan_route
{

/// The result as one JSON object.
std::string jsonReport(const Options &options, const Result &result);

/// The result for people: the chart, the cells, the search, the route, and what to look out for.
std::string textReport(const Options &options, const Result &result);

/// One line with the numbers, for the picture.
std::string summaryLine(const Options &options, const Result &result);

/// Writes the GeoJSON file of --out.
/// @throws demos::Failure (Exit::Usage) if it can't be written
void writeRouteFile(const Options &options, const Result &result);

}  // namespace plan_route
