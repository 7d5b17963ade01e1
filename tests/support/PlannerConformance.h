#pragma once

#include "support/conformance/PlannerArena.h"

#include <ompl/base/Planner.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace seahex::test
{

class Trial;

/// A planner and what it promises. Checks that it does not keep are named, each with the reason.
struct PlannerUnderTest
{
    std::string name;
    std::function<ompl::base::PlannerPtr(const ompl::base::SpaceInformationPtr &)> make;

    /// The same question has the same answer, state by state.
    bool deterministic = false;
    /// Ends by itself: with its best path, or when it knows that there is none. Others are given objectives that any
    /// path satisfies, and little time where there is no path.
    bool finishes = false;
    /// States that a user's checker is asked for between two looks at the termination condition, at most.
    int questionsBetweenLooks = 0;
    /// No state outlives planner and problems. (Some of OMPL's keep what they exported for good.)
    bool freesEveryState = true;
    /// Its path is the cheapest of a graph, so that a problem of several starts and goals costs as much as the best
    /// pair.
    bool optimal = false;
    /// On a chart of hexagons the cost is at most the optimum over the chart's jump graph of so many rings, and just
    /// that if `optimal`; 0: nothing is said.
    int rings = 0;
    /// The same on a chart of squares, for steps to so many neighbours.
    int neighbours = 0;
    /// Progress properties that are there, "words TYPE".
    std::vector<std::string> progress = {"best cost REAL"};
    /// Parameters and values that are refused.
    std::vector<std::pair<std::string, std::string>> refusedSettings = {};
    /// The arenas to run in are those whose name this regular expression matches.
    std::string arenas = ".* in (R2|SE2|Cells)";
    /// Name of a check, and why it is not kept.
    std::map<std::string, std::string> exceptions = {};
};

/// What a check found wrong, in words.
using Violations = std::vector<std::string>;

/// One clause of the contract between a planner and OMPL (the documentation of ompl::base::Planner, and what OMPL's own
/// planners, Benchmark and SimpleSetup make of it).
struct PlannerCheck
{
    std::string name;
    std::function<void(Trial &)> run;
};

/// The arenas that a planner is to be run in.
std::vector<PlannerArena> arenasFor(const PlannerUnderTest &planner);

/// All checks, by theme. Beside its own clause each check judges every solution that comes up (see Trial::solve).
const std::vector<PlannerCheck> &plannerChecks();

/// Runs a check. An exception that leaves the planner is a violation, and so are states that are left over when planner
/// and problems are gone.
Violations violationsOf(const PlannerCheck &check, const PlannerUnderTest &planner, const PlannerArena &arena);

}  // namespace seahex::test
