#pragma once

#include "support/Random.h"

#include <seahex/geometry/HexLattice.h>
#include <seahex/planning/HexAStar.h>
#include <seahex/planning/SquareAStar.h>
#include <seahex/world/Occupancy.h>

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace seahex::test
{

enum class SpaceKind
{
    Plane,  ///< R^2
    Pose,   ///< SE(2)
    Cells   ///< HexStateSpace
};

/// R^2 or SE(2) with these bounds of x and y, or cells of pitch 1 that cover them.
ompl::base::StateSpacePtr spaceWithin(const Box &bounds, SpaceKind kind);

/// A space whose problem is an occupancy, set up; its bounds are those of the lattice unless others are given. Cells
/// are the occupancy's own, which must be hexagons.
ompl::base::SpaceInformationPtr chartSpace(const std::shared_ptr<const Occupancy> &occupancy,
                                           SpaceKind kind = SpaceKind::Plane);
ompl::base::SpaceInformationPtr chartSpace(const std::shared_ptr<const Occupancy> &occupancy, SpaceKind kind,
                                           const Box &bounds);

/// A space with a user's own checker and OMPL's motion validator, set up.
ompl::base::SpaceInformationPtr userSpace(const Box &bounds, SpaceKind kind,
                                          const ompl::base::StateValidityCheckerFn &isValid);

ompl::base::ScopedState<> stateAt(const ompl::base::SpaceInformationPtr &si, const Point &p, double heading = 0.0);
Point positionOf(const ompl::base::SpaceInformationPtr &si, const ompl::base::State *state);

/// From one point to another, with no objective.
ompl::base::ProblemDefinitionPtr problemBetween(const ompl::base::SpaceInformationPtr &si, const Point &start,
                                                const Point &goal);

/// A planner that was given the problem, for the lattice's best path: neither anytime nor smoothing.
template <class Planner = HexAStar>
std::shared_ptr<Planner> plannerFor(const ompl::base::ProblemDefinitionPtr &problem)
{
    auto planner = std::make_shared<Planner>(problem->getSpaceInformation());
    planner->setProblemDefinition(problem);
    planner->setSmoothing(false);
    if constexpr (std::is_same_v<Planner, HexAStar>)
        planner->setAnytime(false);
    return planner;
}

/// The path of the best solution; nullptr if the problem has none.
std::shared_ptr<ompl::geometric::PathGeometric> pathOf(const ompl::base::ProblemDefinitionPtr &problem);

/// Sum of the straight legs of a path, in the plane.
double lengthOf(const ompl::geometric::PathGeometric &path);

/// Distance from a segment to the nearest blocked cell, those around the lattice included: every cell by itself, by
/// CellOracle.
long double distanceToBlocked(const Occupancy &occupancy, const Point &a, const Point &b);

/// A point that touches free cells only; the cells are tried at random. The occupancy must have such a cell.
Point freePoint(Random &random, const Occupancy &occupancy);

/// Obstacles of a plane with no lattice: discs.
struct Discs
{
    std::vector<Point> centres;
    std::vector<double> radii;

    bool isFree(const Point &a, const Point &b) const;
    bool isFree(const Point &p) const { return isFree(p, p); }
};

/// Up to `most` discs, and walls made of discs, in the box.
Discs randomDiscs(Random &random, const Box &box, int most);

/// A termination condition that remembers what happened between two looks at it.
class Watch
{
public:
    /// @param stop  given the number of the look, from 1: is it over?
    explicit Watch(std::function<bool(int)> stop) : stop_(std::move(stop)) {}

    ompl::base::PlannerTerminationCondition condition()
    {
        return ompl::base::PlannerTerminationCondition([this] { return look(); });
    }
    /// Something happened that should not happen too often between two looks.
    void tick() { mostTicks_ = std::max(mostTicks_, ++ticks_); }

    int looks() const { return looks_; }
    int mostTicks() const { return mostTicks_; }

private:
    bool look()
    {
        ticks_ = 0;
        return stop_(++looks_);
    }

    std::function<bool(int)> stop_;
    int looks_ = 0;
    int ticks_ = 0;
    int mostTicks_ = 0;
};

}  // namespace seahex::test
