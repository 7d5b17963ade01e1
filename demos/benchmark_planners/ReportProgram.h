#pragma once

#include "Options.h"

namespace benchmark_planners
{

/// Runs the Python program that merges the folders' logs into one database, computes the statistics, prints the table
/// (or the JSON object) and writes plots and page into --out.
/// @throws demos::Failure (Exit::Report) with its own sentence if it can't
void makeReport(const Options &options, const std::vector<std::string> &folders);

}  // namespace benchmark_planners
