#pragma once

#include <seahex/world/Occupancy.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace seahex
{

/// An occupancy in larger cells: a hexagon `factor` times as wide is free only if every cell of the fine occupancy that
/// touches it is. So whatever is free in it is free in the fine one, and narrow waters are lost.
///
/// The centres of large cells are centres of fine ones, so that what touches what is decided in integers: two closed
/// hexagons of one orientation, w and 1 pitches wide, touch if and only if the difference (q, r, s) of their centres
/// has max(|q - r|, |r - s|, |s - q|) <= w + 1.
///
/// Immutable. Time of construction: linear in fine cells over the factor.
class CoarseOccupancy
{
public:
    /// @param fine  of hexagons
    /// @param factor  at least 2
    CoarseOccupancy(const Occupancy &fine, std::int64_t factor);

    std::int64_t factor() const { return factor_; }
    const HexOccupancy &cells() const { return *cells_; }

    /// The fine cell in the middle of a large one.
    HexCoord middle(HexCoord large) const { return factor_ * large; }
    /// A large cell that holds the centre of a fine one, on its edge perhaps. The straight line from there to the large
    /// cell's middle stays within it.
    HexCoord holding(HexCoord fine) const;

private:
    std::int64_t factor_;
    std::shared_ptr<const HexOccupancy> cells_;
};

/// Coarser occupancies of one of hexagons, the finest first, each twice as coarse as the one before: those with some
/// thousands of cells up to some ten thousands, which are searched in a tenth of a millisecond; none for a lattice that
/// is small itself.
std::vector<std::shared_ptr<const CoarseOccupancy>> coarseOccupancies(const Occupancy &fine);

}  // namespace seahex
