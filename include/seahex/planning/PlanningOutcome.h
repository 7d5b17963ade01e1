#pragma once

namespace seahex
{

/// How the last solve() of a planner of this library ended. OMPL 1.5's PlannerStatus has no word for an exhausted
/// search.
enum class PlanningOutcome
{
    None,          ///< not asked yet
    Found,         ///< a path, and all that the settings ask for is done
    Improvable,    ///< a path, but ended before that, by the termination condition or the objective's threshold
    Exhausted,     ///< no path at this resolution; a finer one may have one
    OutOfTime,     ///< stopped by the termination condition; solve() again continues
    InvalidStart,  ///< no start is valid and joined to the search
    InvalidGoal    ///< no goal is valid and joined to the search
};

}  // namespace seahex
