#pragma once

#include <seahex/planning/SlicePlanner.h>

#include <string>

namespace seahex
{

/// The layered planning of [Xu] for problems in R^3: one point of every slice between start and goal.
///
/// "greedy" is the published selection: plane by plane the point with the least distance from the one before and from
/// the reference line to the goal (GreedySelection). It is quick, asks for little, and may walk into a dead end, which
/// deadEnds() tells. "exact" (the default) finds the path of least F over the same slices (ExactSelection), never worse
/// in F than greedy; where it ends in a dead end there is no path on these slices. Slices, validity, answers and status
/// are those of SlicePlanner.
class LayeredPlanner : public SlicePlanner
{
public:
    enum class Mode
    {
        Greedy,
        Exact
    };

    /// @throws ompl::Exception if the space is not R^3
    explicit LayeredPlanner(const ompl::base::SpaceInformationPtr &si);

    void setMode(Mode mode);
    /// "greedy" or "exact". @throws ompl::Exception for another
    void setMode(const std::string &mode);
    std::string getMode() const { return mode_ == Mode::Greedy ? "greedy" : "exact"; }

private:
    std::unique_ptr<SliceSearch> makeSearch(const SliceProblem &problem) const override;

    Mode mode_ = Mode::Exact;
};

}  // namespace seahex
