#pragma once

#include <seahex/planning/PlanarEmbedding.h>

#include <ompl/base/OptimizationObjective.h>

namespace seahex
{

/// The sum of all changes of heading, in radians.
///
/// A motion sees its two states only, so it is defined where states have a heading, SE(2): to go from s1 to s2 one
/// turns on the spot from s1's yaw to the course, and on arrival from the course to s2's yaw; with no way between them,
/// from yaw to yaw. Each turn is the smaller angle, in [0, pi]. A path whose yaws are the courses of the legs that led
/// there (as HexAStar's are) costs the sum of the turns at its waypoints: RouteMetrics::turnAngleRad, but for what that
/// leaves out as no turn (up to leastTurnRad a waypoint), and the turns from the first state's yaw and to the last
/// one's.
///
/// Not symmetric: back from s2 to s1 the course is the opposite one, and the yaws are not. Adds up along a line where
/// the states between have the course as their yaw; the ones that SE(2) interpolates turn away from it, and cutting a
/// motion there makes it dearer, never cheaper.
///
/// Heuristic: the motion's own cost, less a billionth of a radian for rounding: no path turns less than the straight
/// motion does (the proof stands beside the code). The difference of the two yaws is a bound too, and a weaker one.
/// Const, thread-safe.
class TurnAngleObjective : public ompl::base::OptimizationObjective
{
public:
    /// @throws ompl::Exception if the space is not SE(2)
    explicit TurnAngleObjective(const ompl::base::SpaceInformationPtr &si);

    /// Identity: only motions turn.
    ompl::base::Cost stateCost(const ompl::base::State *state) const override;
    ompl::base::Cost motionCost(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    ompl::base::Cost motionCostHeuristic(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    ompl::base::InformedSamplerPtr allocInformedStateSampler(const ompl::base::ProblemDefinitionPtr &problem,
                                                             unsigned int maxNumberCalls) const override;
    bool isSymmetric() const override { return false; }

private:
    PlanarEmbedding embedding_;
};

}  // namespace seahex
