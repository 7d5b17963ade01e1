#include "planning/HexStateSampler.h"

#include <algorithm>
#include <cmath>

namespace ob = ompl::base;

namespace seahex
{
namespace
{

HexStateSpace::StateType *cast(ob::State *state)
{
    return state->as<HexStateSpace::StateType>();
}

/// How many rows or columns a distance reaches: rounding must not lose the outermost, and need not go beyond `most`.
std::int64_t reach(double distance, double spacing, std::int64_t most)
{
    const double count = std::floor(distance / spacing + 1e-6);
    return count < static_cast<double>(most) ? static_cast<std::int64_t>(std::max(count, 0.0)) : most;
}

}  // namespace

HexStateSampler::HexStateSampler(const HexStateSpace *space) : ob::StateSampler(space), hexagons_(*space) {}

std::int64_t HexStateSampler::integer(std::int64_t first, std::int64_t last)
{
    // not RNG::uniformInt, which ends at 2^31; the bias, below 2^-50 of the range, does not matter
    const double count = static_cast<double>(last - first + 1);
    return std::min(first + static_cast<std::int64_t>(std::floor(count * rng_.uniform01())), last);
}

void HexStateSampler::sampleUniform(ob::State *state)
{
    const std::int64_t column = integer(0, hexagons_.lattice().columns() - 1);
    cast(state)->setCell(toCube({column, integer(0, hexagons_.lattice().rows() - 1)}));
}

void HexStateSampler::sampleUniformNear(ob::State *state, const ob::State *near, double distance)
{
    const HexLattice &lattice = hexagons_.lattice();
    HexStateSpace::StateType centre;
    hexagons_.copyState(&centre, near);
    hexagons_.enforceBounds(&centre);
    const double radius = distance > 0.0 ? distance : 0.0;

    // Cells of the rectangle around the disc, until one lies within the disc: at worst one in nine does.
    const OffsetCoord middle = toOffset(centre.cell());
    const std::int64_t up = reach(radius, 1.5 * lattice.side(), lattice.rows());
    const std::int64_t across = reach(radius + 0.5 * lattice.pitch(), lattice.pitch(), lattice.columns());
    const std::int64_t north = std::max<std::int64_t>(middle.row - up, 0);
    const std::int64_t south = std::min(middle.row + up, lattice.rows() - 1);
    const std::int64_t west = std::max<std::int64_t>(middle.column - across, 0);
    const std::int64_t east = std::min(middle.column + across, lattice.columns() - 1);
    HexStateSpace::StateType drawn;
    do
    {
        const std::int64_t column = integer(west, east);
        drawn.setCell(toCube({column, integer(north, south)}));
    } while (hexagons_.distance(&centre, &drawn) > radius);
    hexagons_.copyState(state, &drawn);
}

void HexStateSampler::sampleGaussian(ob::State *state, const ob::State *mean, double stdDev)
{
    const HexLattice &lattice = hexagons_.lattice();
    HexStateSpace::StateType centre;
    hexagons_.copyState(&centre, mean);
    hexagons_.enforceBounds(&centre);
    const Point p = lattice.centre(centre.cell());
    const double x = rng_.gaussian(p.x(), stdDev);
    cast(state)->setCell(lattice.cellAt({x, rng_.gaussian(p.y(), stdDev)}));
    hexagons_.enforceBounds(state);
}

}  // namespace seahex
