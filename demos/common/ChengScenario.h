#pragma once

#include <seahex/geometry/HexLattice.h>

namespace demos
{

/// The scenario of [Cheng2020], decoded from its numbers: a plate carree lattice off Shangchuan, land only.
namespace cheng2020
{

constexpr double westDeg = 112.50;  ///< of the lattice's north-west corner
constexpr double northDeg = 21.98;
constexpr double sideDeg = 0.002;  ///< of a hexagon; the pitch is root 3 times that
constexpr int columns = 143;
constexpr int rows = 159;
constexpr const char *from = "21.635,112.521";
constexpr const char *to = "21.669,112.901";
constexpr const char *chart = "shangchuan.000";

/// Width of a published cell, degrees.
double publishedPitchDeg();

/// The published lattice; with another pitch (degrees) one of the same corner over the same window.
seahex::HexLattice lattice(double pitchDeg);

}  // namespace cheng2020

}  // namespace demos
