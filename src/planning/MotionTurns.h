#pragma once

#include "seahex/planning/PlanarEmbedding.h"

#include <cmath>

namespace seahex
{

/// The turns of a motion that goes straight from one state with a heading to another, radians in [0, pi].
struct MotionTurns
{
    double departure = 0.0;  ///< from the first state's heading to the course
    double arrival = 0.0;    ///< from the course to the second state's heading
};

inline double turnBetween(double heading, double other)
{
    constexpr double fullTurn = 2.0 * 3.14159265358979323846;
    return std::abs(std::remainder(other - heading, fullTurn));
}

/// Without a way to go there is no course, and one turn on the spot: the departure.
inline MotionTurns turnsOf(const PlanarEmbedding &embedding, const ompl::base::State *s1, const ompl::base::State *s2)
{
    const Point way = embedding.position(s2) - embedding.position(s1);
    if (way.isZero(0.0))
        return {turnBetween(embedding.heading(s1), embedding.heading(s2)), 0.0};
    const double course = std::atan2(way.y(), way.x());
    return {turnBetween(embedding.heading(s1), course), turnBetween(course, embedding.heading(s2))};
}

/// An embedding of states that have a heading. @throws ompl::Exception if the space's states have none
PlanarEmbedding embeddingWithHeading(const ompl::base::StateSpace *space);

}  // namespace seahex
