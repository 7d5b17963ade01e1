#pragma once

#include <seahex/planning/PlanarEmbedding.h>
#include <seahex/world/Occupancy.h>

#include <ompl/base/MotionValidator.h>

#include <memory>

namespace seahex
{

/// A motion is valid if every closed cell that its straight line touches is free, and both its ends are within the
/// space's bounds: exact, without a sampling resolution, symmetric, and for every planner alike. Const; thread-safe but
/// for OMPL's own counters of valid and invalid motions, which may miss some where several threads ask.
class OccupancyMotionValidator : public ompl::base::MotionValidator
{
public:
    /// @throws ompl::Exception if the space is not planar (PlanarEmbedding)
    OccupancyMotionValidator(const ompl::base::SpaceInformationPtr &si, std::shared_ptr<const Occupancy> occupancy);

    bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2) const override;

    /// If the motion is invalid, lastValid.second is the largest fraction of it that is valid, to a 2^-40th of the way,
    /// and lastValid.first, if not null, the state there; it may be s2 itself. The motion from s1 to that state is
    /// itself valid. 0 and s1 where s1 is invalid.
    ///
    /// In a HexStateSpace the fractions are whole steps between neighbours, and the state is the cell there: the last
    /// one on the valid part of the line to which the motion from s1, another line, is valid as well.
    bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2,
                     std::pair<ompl::base::State *, double> &lastValid) const override;

    const std::shared_ptr<const Occupancy> &occupancy() const { return occupancy_; }

private:
    double lastValidFraction(const ompl::base::State *s1, const ompl::base::State *s2, ompl::base::State *state) const;
    double lastValidStep(const ompl::base::State *s1, const ompl::base::State *s2, ompl::base::State *state) const;

    PlanarEmbedding embedding_;
    std::shared_ptr<const Occupancy> occupancy_;
};

}  // namespace seahex
