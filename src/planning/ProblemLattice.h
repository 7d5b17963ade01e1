#pragma once

#include "seahex/geometry/Lattice.h"
#include "seahex/planning/PlanarEmbedding.h"
#include "seahex/world/Occupancy.h"

#include <ompl/base/SpaceInformation.h>

#include <memory>

namespace seahex
{

/// The occupancy of which checker and motion validator of a problem both are; nullptr if the problem is another.
/// Classes derived from the two may say more than the occupancy does, so they make another problem; so does a
/// HexStateSpace of another lattice, whose states do not lie at the occupancy's centres, and an occupancy more than
/// 10^7 pitches from the origin.
std::shared_ptr<const Occupancy> sharedOccupancy(const ompl::base::SpaceInformation &si);

/// The occupancy less the cells whose centres lie outside the box: these are blocked. The same one if there are none.
std::shared_ptr<const Occupancy> withinBounds(const std::shared_ptr<const Occupancy> &occupancy, const Box &box);

/// The lattice of a problem with no chart: the space's own, if it is a HexStateSpace, or one laid over its bounds.
/// @param requestedCellSize  pitch of the latter; 0 for a 200th of the largest extent
/// @tparam KnownLattice  HexLattice or SquareLattice
/// @throws ompl::Exception if it would have more than 10^6 cells, or the space has more than 10^7
template <class KnownLattice>
KnownLattice layLattice(const PlanarEmbedding &embedding, double requestedCellSize);

/// Answers are kept for every cell and jump: up to 37 bytes a cell.
/// @throws ompl::Exception if the lattice has more than 10^7 cells
void requireAskable(const Lattice &lattice);

}  // namespace seahex
