#include "support/Random.h"

#include "support/AsciiWorld.h"

#include <vector>

namespace seahex::test
{

std::int64_t Random::integer(std::int64_t low, std::int64_t high)
{
    // the bias of the remainder, below 2^-30 for the ranges of tests, does not matter
    const std::uint64_t range = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + engine_() % range);
}

Point Random::pointIn(const Box &box)
{
    const double x = real(box.min.x(), box.max.x());
    return {x, real(box.min.y(), box.max.y())};
}

Point Random::pointOf(const Point &centre, const Point *corners, std::size_t count)
{
    const auto corner = [&]() -> const Point &
    {
        return corners[integer(0, static_cast<std::int64_t>(count) - 1)];
    };
    const Point &a = corner();
    const Point &b = corner();
    switch (integer(0, 7))
    {
        case 0:
            return centre;
        case 1:
            return a;
        case 2:
            return a + unit() * (b - a);
        default:
            return centre + unit() * (a + unit() * (b - a) - centre);
    }
}

template <class LatticeType>
std::shared_ptr<const LatticeOccupancy<LatticeType>> randomOccupancy(Random &random, const LatticeType &lattice,
                                                                     double density)
{
    std::vector<typename LatticeType::Cell> blocked;
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < lattice.columns(); ++column)
            if (random.chance(density))
                blocked.push_back(LatticeType::cell({column, row}));
    return occupancyWith(lattice, blocked);
}

template std::shared_ptr<const HexOccupancy> randomOccupancy(Random &, const HexLattice &, double);
template std::shared_ptr<const SquareOccupancy> randomOccupancy(Random &, const SquareLattice &, double);

}  // namespace seahex::test
