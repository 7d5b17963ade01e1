#include "seahex/planning/LayeredPlanner.h"

#include "seahex/slices/ExactSelection.h"
#include "seahex/slices/GreedySelection.h"

#include <ompl/util/Exception.h>

namespace seahex
{

LayeredPlanner::LayeredPlanner(const ompl::base::SpaceInformationPtr &si) : SlicePlanner(si, "LayeredPlanner")
{
    params_.declareParam<std::string>(
        "mode", [this](const std::string &mode) { setMode(mode); }, [this] { return getMode(); });
    params_["mode"].setRangeSuggestion("greedy,exact");
}

void LayeredPlanner::setMode(Mode mode)
{
    mode_ = mode;
    forgetSearch();
}

void LayeredPlanner::setMode(const std::string &mode)
{
    if (mode != "greedy" && mode != "exact")
        throw ompl::Exception(getName(), "mode must be greedy or exact, not '" + mode + "'");
    setMode(mode == "greedy" ? Mode::Greedy : Mode::Exact);
}

std::unique_ptr<SliceSearch> LayeredPlanner::makeSearch(const SliceProblem &problem) const
{
    if (mode_ == Mode::Greedy)
        return std::make_unique<GreedySelection>(problem);
    return std::make_unique<ExactSelection>(problem);
}

}  // namespace seahex
