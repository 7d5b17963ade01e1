#include "seahex/geometry/PrismLattice.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace seahex
{

PrismLattice::PrismLattice(const HexLattice &plane, double top, double thickness, int layers)
    : plane_(plane), top_(top), thickness_(thickness), layers_(layers),
      bottom_(top + static_cast<double>(layers - 1) * thickness)
{
    if (!std::isfinite(top) || !std::isfinite(thickness) || thickness <= 0.0 || layers <= 0)
        throw std::domain_error("layers must be one or more, and a positive distance apart");
}

PrismLattice PrismLattice::between(const HexLattice &plane, double top, double bottom, double thickness)
{
    if (!(bottom > top))
        return {plane, top, thickness, 1};
    // The rounding of a quotient must not make a layer more.
    const double steps = std::max(1.0, std::ceil((bottom - top) / thickness * (1.0 - 1e-12)));
    if (!(steps < 1e4))
        throw std::domain_error("more than 10000 layers");
    PrismLattice lattice(plane, top, (bottom - top) / steps, static_cast<int>(steps) + 1);
    lattice.bottom_ = bottom;
    return lattice;
}

}  // namespace seahex
