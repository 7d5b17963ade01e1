#include "planning/PathsAsData.h"

#include <ompl/base/SpaceInformation.h>

#include <algorithm>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex
{

void writePaths(const std::vector<std::shared_ptr<og::PathGeometric>> &paths, const EndStates &ends,
                const ob::OptimizationObjective &objective, ob::PlannerData &data)
{
    for (const ob::State *start : ends.starts())
        data.addStartVertex(ob::PlannerDataVertex(start));
    for (const auto &path : paths)
    {
        const ob::SpaceInformationPtr &si = path->getSpaceInformation();
        const auto ownOf = [&](const std::vector<ob::State *> &states, const ob::State *state) -> const ob::State *
        {
            return *std::find_if(states.begin(), states.end(),
                                 [&](const ob::State *own) { return si->equalStates(own, state); });
        };
        const std::vector<ob::State *> &states = path->getStates();
        const ob::State *goal = ownOf(ends.goals(), states.back());
        data.addGoalVertex(ob::PlannerDataVertex(goal));
        const ob::State *before = ownOf(ends.starts(), states.front());
        for (std::size_t i = 1; i < states.size(); ++i)
        {
            const ob::State *state = i + 1 == states.size() ? goal : states[i];
            data.addVertex(ob::PlannerDataVertex(state));
            data.addEdge(data.vertexIndex(ob::PlannerDataVertex(before)),
                         data.vertexIndex(ob::PlannerDataVertex(state)), ob::PlannerDataEdge(),
                         objective.motionCost(before, state));
            before = state;
        }
    }
}

}  // namespace seahex
