#pragma once

#include <seahex/planning/PlanarEmbedding.h>

#include <optional>

namespace seahex::test
{

/// Where states of an arena's space are, seen from above. In R^3 places lie at a height of 1.7, and obstacles are
/// columns from the bottom to the top.
class Footing
{
public:
    explicit Footing(const ompl::base::StateSpace *space);

    void place(ompl::base::State *state, const Point &p, double heading = 0.0) const;
    Point position(const ompl::base::State *state) const;
    bool hasHeading() const { return planar_ && planar_->hasHeading(); }
    bool isSolid() const { return !planar_; }

private:
    std::optional<PlanarEmbedding> planar_;  // empty in R^3
};

}  // namespace seahex::test
