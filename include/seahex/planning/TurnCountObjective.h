#pragma once

#include <seahex/planning/PlanarEmbedding.h>

#include <ompl/base/OptimizationObjective.h>

namespace seahex
{

/// How often the heading changes by more than leastTurnRad (RouteMetrics).
///
/// The turns are those of TurnAngleObjective, which see: on departure from s1's yaw to the course, on arrival from the
/// course to s2's yaw; a motion has none, one or two. So it is defined in SE(2) only. A path whose yaws are the courses
/// of the legs that led there (as HexAStar's are) costs RouteMetrics::turns, and the turns from the first state's yaw
/// and to the last one's. Runs of bends too small to count differ: here each is seen by itself.
///
/// Not symmetric. Adds up along a line where the states between have the course as their yaw.
///
/// Heuristic: identity, which is admissible for any objective without negative costs, and no more. A straight motion
/// may turn twice where a path with a corner turns once, and a path of bends too small to count turns as far as one
/// likes at no cost.
/// Const, thread-safe.
class TurnCountObjective : public ompl::base::OptimizationObjective
{
public:
    /// @throws ompl::Exception if the space is not SE(2)
    explicit TurnCountObjective(const ompl::base::SpaceInformationPtr &si);

    /// Identity: only motions turn.
    ompl::base::Cost stateCost(const ompl::base::State *state) const override;
    ompl::base::Cost motionCost(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    bool isSymmetric() const override { return false; }

private:
    PlanarEmbedding embedding_;
};

}  // namespace seahex
