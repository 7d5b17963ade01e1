#include "seahex/geometry/HexNorm.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace seahex
{
namespace
{

/// Of coordinates (q, r, s) of which the largest in size is the sum of the other two: these are m and n.
double normOf(std::array<double, 3> size, int rings)
{
    static const double root3 = std::sqrt(3.0);
    static const double root7 = std::sqrt(7.0);
    std::sort(size.begin(), size.end());
    const double n = size[0];
    const double m = size[1];
    if (rings == 1)
        return m + n;
    if (rings == 2)
        return (m - n) + n * root3;
    return m >= 2.0 * n ? (m - 2.0 * n) + n * root7 : (m - n) * root7 + (2.0 * n - m) * root3;
}

}  // namespace

double hexNorm(const Point &vector, const HexLattice &lattice)
{
    const double s = -vector.y() / (1.5 * lattice.side());
    const double q = vector.x() / lattice.pitch() - 0.5 * s;
    return std::max({std::abs(q), std::abs(s), std::abs(q + s)});
}

double ringNorm(HexCoord difference, int rings)
{
    return normOf({static_cast<double>(std::abs(difference.q)), static_cast<double>(std::abs(difference.r())),
                   static_cast<double>(std::abs(difference.s))},
                  rings);
}

double vectorRingNorm(const Point &vector, int rings)
{
    static const double rowStep = 0.5 * std::sqrt(3.0);
    const double s = -vector.y() / rowStep;
    const double q = vector.x() - 0.5 * s;
    return normOf({std::abs(q), std::abs(q + s), std::abs(s)}, rings);
}

}  // namespace seahex
