#pragma once

#include "Job.h"
#include "Options.h"

#include <string>

namespace plan_dive
{

/// The result as one JSON object.
std::string jsonReport(const Options &options, const Result &result);

/// The result for people: the seabed, the search, the dive.
std::string textReport(const Options &options, const Result &result);

/// One line with the numbers, for the pictures.
std::string summaryLine(const Options &options, const Result &result);

/// Writes the GeoJSON file of --out.
/// @throws demos::Failure (Exit::Usage) if it can't be written
void writeDiveFile(const Options &options, const Result &result);

}  // namespace plan_dive
