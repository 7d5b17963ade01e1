#pragma once

#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/SquareLattice.h>

#include "support/HexOracle.h"
#include "support/SquareOracle.h"

#include <string>
#include <type_traits>

#include <gtest/gtest.h>

namespace seahex::test
{

/// For tests of what is promised of hexagons and of squares alike:
///
///     template <class LatticeType>
///     class Xyz : public testing::Test {};
///     TYPED_TEST_SUITE(Xyz, LatticeKinds, LatticeKindNames);
///     TYPED_TEST(Xyz, ...) { const TypeParam lattice(...); }
using LatticeKinds = testing::Types<HexLattice, SquareLattice>;

struct LatticeKindNames
{
    template <class LatticeType>
    static std::string GetName(int)
    {
        return std::is_same_v<LatticeType, HexLattice> ? "Hexagons" : "Squares";
    }
};

/// How many cells meet in a corner.
template <class LatticeType>
constexpr std::size_t cellsAtCorner = std::is_same_v<LatticeType, HexLattice> ? 3 : 4;

/// Multiples of these make a grid that all centres, corners and middles of edges lie on.
inline Point cornerGrid(const HexLattice &lattice)
{
    return {0.25 * lattice.pitch(), 0.25 * lattice.side()};
}
inline Point cornerGrid(const SquareLattice &lattice)
{
    return Point::Constant(0.25 * lattice.pitch());
}

}  // namespace seahex::test
