#pragma once

#include "Waters.h"

#include <seahex/geometry/Point.h>
#include <seahex/world/Occupancy.h>

#include <cstdint>
#include <vector>

namespace demos
{

/// A start and a goal in the plane.
struct Pair
{
    unsigned number = 0;  ///< from 1
    seahex::Point start;
    seahex::Point goal;

    double distance() const { return (goal - start).norm(); }
    /// Course of the straight line, degrees clockwise from north, 0 to 360.
    double courseDeg() const;
};

/// What pairs to draw.
struct PairRules
{
    unsigned count = 1;
    double leastDistance = 0.0;  ///< as a share of the diagonal of the lattice's box
    std::uint32_t seed = 1;
    /// The straight line between the two is blocked, so that planners have something to do.
    bool needsDetour = true;
};

/// Draws start-goal pairs for planners: both lie in the largest water, anywhere in a free cell rather than on its
/// centre. The course of pair k of n lies in the k-th of n equal sectors of the compass. The same on every machine for
/// the same occupancy and rules.
/// @throws Failure (Exit::NotNavigable) if a sector has no such pair
std::vector<Pair> drawPairs(const seahex::Occupancy &occupancy, const LargestWater &water, const PairRules &rules);

/// The same for several lattices over one water: a pair will do on each of them.
std::vector<Pair> drawPairs(const std::vector<const seahex::Occupancy *> &occupancies, const PairRules &rules);

}  // namespace demos
