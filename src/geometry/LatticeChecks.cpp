#include "geometry/LatticeChecks.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace seahex
{
namespace
{

void requirePitch(double pitch)
{
    if (!std::isfinite(pitch) || pitch <= 0.0)
        throw std::domain_error("pitch must be positive, not " + std::to_string(pitch));
}

}  // namespace

std::int64_t toCoordinate(double number)
{
    constexpr std::int64_t limit = std::int64_t{1} << 60;
    if (!(number > -static_cast<double>(limit)))
        return -limit;
    return number < static_cast<double>(limit) ? static_cast<std::int64_t>(number) : limit;
}

void requireLattice(const Point &northWest, double pitch, std::int64_t columns, std::int64_t rows)
{
    requirePitch(pitch);
    if (!northWest.allFinite())
        throw std::domain_error("the lattice's origin is not a number");
    if (columns <= 0 || rows <= 0)
        throw std::domain_error("a lattice needs at least one column and one row, not " + std::to_string(columns) +
                                " x " + std::to_string(rows));
}

Point extentToCover(const Box &box, double pitch)
{
    requirePitch(pitch);
    const Point extent = box.max - box.min;
    if (!extent.allFinite() || extent.x() < 0.0 || extent.y() < 0.0)
        throw std::domain_error("the box to be covered is empty or not finite");
    return extent;
}

void requireCellCount(double pitch, double columns, double rows)
{
    if (columns * rows > std::ldexp(1.0, 40))
        throw std::domain_error("a pitch of " + std::to_string(pitch) + " would need " +
                                std::to_string(columns * rows) + " cells: at most 2^40");
}

}  // namespace seahex
