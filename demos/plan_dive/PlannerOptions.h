#pragma once

#include "Options.h"

#include <string>

namespace CLI
{
class App;
}

namespace plan_dive
{

/// The words of planners' options that are numbers or "auto".
struct PlannerTexts
{
    std::string vehicleLength = "auto";
    std::string cellSize = "auto";
    std::string layer = "auto";
};

/// A length in metres on the command line; 0 for auto.
/// @throws demos::Failure (Exit::Usage) for anything else
double positiveOrAuto(const char *option, const std::string &text);

/// Declares --planner and all that tells a planner how to search. The help has an option's planners beside it.
void declarePlanner(CLI::App &app, Options &options, PlannerTexts &texts);

/// Checks these options and fills them in. One that the planner chosen doesn't know is refused: a limit that is set
/// aside in silence is no limit.
/// @throws demos::Failure (Exit::Usage)
void resolvePlanner(const CLI::App &app, Options &options, const PlannerTexts &texts);

}  // namespace plan_dive
