#pragma once

#include <cmath>
#include <limits>

namespace seahex
{

/// Costs that add up and of which less is better: the base of lattices that measure length.
struct LengthAlgebra
{
    static double combine(double a, double b) { return a + b; }
    static bool better(double a, double b) { return a < b; }
    static double worst() { return std::numeric_limits<double>::infinity(); }

    /// Sums of the same jumps in another order differ in the last digits; that is no improvement.
    static bool improves(double cost, double known) { return cost < known - 1e-12 * (1.0 + known); }

    /// Rounded down to a multiple of 2^-30, so that paths of equal length have equal keys and the tie-break decides.
    static double key(double estimate) { return std::floor(estimate * 1073741824.0) * (1.0 / 1073741824.0); }
};

}  // namespace seahex
