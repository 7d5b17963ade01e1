#pragma once

#include <seahex/geometry/Lattice.h>
#include <seahex/geometry/Shape.h>
#include <seahex/world/CellBits.h>
#include <seahex/world/Occupancy.h>
#include <seahex/world/ScanlineFill.h>

#include <memory>
#include <vector>

namespace seahex
{

/// Fills an occupancy: any touch blocks.
///
/// Lattices: HexLattice and SquareLattice. A cell is blocked if the exact distance from a shape to the closed cell is
/// <= the shape's radius; nothing is sampled and nothing is buffered by polygons (an approximated round buffer lies
/// inside the true one). For doubles "exact" means a superset: a cell within 1e-9 times the largest coordinate beyond
/// the radius may be blocked too (SegmentSpans).
///
/// Time is linear in the shapes' segments, the cells along them, and the 64-bit words of their insides.
template <class KnownLattice>
class OccupancyBuilder
{
public:
    explicit OccupancyBuilder(const KnownLattice &lattice);
    /// Begins with all that another occupancy blocks: a chart's, say, to which a hazard is added that was reported on
    /// the way. Once that is gone, begin again without it.
    explicit OccupancyBuilder(const LatticeOccupancy<KnownLattice> &occupancy);

    /// Blocks every cell within `radius` of the shape (points, lines, filled areas).
    /// @param radius  >= 0, in the plane's unit
    /// @throws std::domain_error if a coordinate is not a number: better no occupancy than one with a hole
    void block(const Shape &shape, double radius);

    /// Blocks every cell that is not wholly inside the areas, or comes within `radius` of their boundary. The areas
    /// must not overlap or share boundaries (unite them first): a seam between two of them would be blocked. Nor may
    /// they cross themselves.
    /// @throws std::domain_error if a coordinate is not a number
    void blockOutside(const std::vector<Polygon> &areas, double radius);

    /// The occupancy of what was blocked so far. A builder that is given away gives its memory with it.
    std::shared_ptr<const LatticeOccupancy<KnownLattice>> build() const &;
    std::shared_ptr<const LatticeOccupancy<KnownLattice>> build() &&;

private:
    void blockNear(const Point &a, const Point &b, double radius);

    KnownLattice lattice_;
    Lattice cells_;  // the same
    CellBits bits_;
    ScanlineFill fill_;
};

extern template class OccupancyBuilder<HexLattice>;
extern template class OccupancyBuilder<SquareLattice>;

}  // namespace seahex
