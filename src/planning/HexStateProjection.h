#pragma once

#include "seahex/planning/HexStateSpace.h"

#include <ompl/base/ProjectionEvaluator.h>

#include <algorithm>

namespace seahex
{

/// A state of HexStateSpace as the point that it stands at.
class HexStateProjection : public ompl::base::ProjectionEvaluator
{
public:
    explicit HexStateProjection(const HexStateSpace *space) : ProjectionEvaluator(space), lattice_(space->lattice()) {}

    unsigned int getDimension() const override { return 2; }

    void defaultCellSizes() override
    {
        constexpr double splits = 20.0;  // as OMPL's own projections have it
        const Box box = lattice_.bounds();
        bounds_.resize(2);
        cellSizes_.resize(2);
        for (unsigned int axis = 0; axis < 2; ++axis)
        {
            bounds_.setLow(axis, box.min[axis]);
            bounds_.setHigh(axis, box.max[axis]);
            cellSizes_[axis] = std::max((box.max[axis] - box.min[axis]) / splits, lattice_.pitch());
        }
    }

    void project(const ompl::base::State *state, Eigen::Ref<Eigen::VectorXd> projection) const override
    {
        projection = lattice_.centre(state->as<HexStateSpace::StateType>()->cell());
    }

private:
    HexLattice lattice_;
};

}  // namespace seahex
