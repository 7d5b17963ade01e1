#pragma once

#include <seahex/geometry/HexLattice.h>
#include <seahex/world/Occupancy.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>

namespace seahex::test
{

/// Random numbers that are the same with every standard library for the same seed. Tests that use one say
/// `SCOPED_TRACE(random.seedText())`, so that a failure names the seed.
class Random
{
public:
    explicit Random(std::uint64_t seed) : seed_(seed), engine_(seed) {}

    std::string seedText() const { return "seed " + std::to_string(seed_); }

    /// Evenly distributed in [0, 1).
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    /// In [low, high).
    double real(double low, double high) { return low + (high - low) * unit(); }
    /// In [low, high], both included.
    std::int64_t integer(std::int64_t low, std::int64_t high);
    bool chance(double probability) { return unit() < probability; }

    Point pointIn(const Box &box);
    /// Any cell of the rectangle.
    template <class LatticeType>
    auto cellOf(const LatticeType &lattice)
    {
        const std::int64_t column = integer(0, lattice.columns() - 1);
        return LatticeType::cell({column, integer(0, lattice.rows() - 1)});
    }
    /// A point of the closed cell: most often inside, else on an edge, a corner, or the centre.
    template <class LatticeType>
    Point pointOf(const LatticeType &lattice, typename LatticeType::Cell cell)
    {
        const auto corners = lattice.corners(cell);
        return pointOf(lattice.centre(cell), corners.data(), corners.size());
    }

private:
    Point pointOf(const Point &centre, const Point *corners, std::size_t count);

    std::uint64_t seed_;
    std::mt19937_64 engine_;
};

/// Calls body(random) with random numbers of the seeds 1 to count; a failure names the seed.
template <class Body>
void forEachSeed(std::uint64_t count, Body &&body)
{
    for (std::uint64_t seed = 1; seed <= count; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        body(random);
    }
}

/// An occupancy in which each cell is blocked with the given probability.
template <class LatticeType>
std::shared_ptr<const LatticeOccupancy<LatticeType>> randomOccupancy(Random &random, const LatticeType &lattice,
                                                                     double density);

}  // namespace seahex::test
