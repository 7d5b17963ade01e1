#pragma once

#include <seahex/planning/PlanarEmbedding.h>
#include <seahex/world/Occupancy.h>

#include <ompl/base/StateValidityChecker.h>

#include <memory>

namespace seahex
{

/// A state is valid if every closed cell that its position touches is free, and it is within the space's bounds.
///
/// Any OMPL planner may use it; const, cache-free, thread-safe. HexAStar reads the occupancy behind it directly, with
/// the same results.
class OccupancyValidityChecker : public ompl::base::StateValidityChecker
{
public:
    /// @throws ompl::Exception if the space is not planar (PlanarEmbedding)
    OccupancyValidityChecker(const ompl::base::SpaceInformationPtr &si, std::shared_ptr<const Occupancy> occupancy);

    bool isValid(const ompl::base::State *state) const override;
    bool isValid(const ompl::base::State *state, double &dist) const override;

    /// Signed, in the plane's unit: distance to the nearest blocked cell, or minus the distance to the nearest free one
    /// (signedClearance). Not more than the distance to any hazard.
    double clearance(const ompl::base::State *state) const override;

    const std::shared_ptr<const Occupancy> &occupancy() const { return occupancy_; }

private:
    PlanarEmbedding embedding_;
    std::shared_ptr<const Occupancy> occupancy_;
};

}  // namespace seahex
