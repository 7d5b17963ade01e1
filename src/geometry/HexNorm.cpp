#include "seahex/geometry/HexNorm.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace seahex
{

double hexNorm(const Point &vector, const HexLattice &lattice)
{
    const double s = -vector.y() / (1.5 * lattice.side());
    const double q = vector.x() / lattice.pitch() - 0.5 * s;
    return std::max({std::abs(q), std::abs(s), std::abs(q + s)});
}

double ringNorm(HexCoord difference, int rings)
{
    static const double root3 = std::sqrt(3.0);
    static const double root7 = std::sqrt(7.0);
    // The largest of |q|, |r|, |s| is the sum of the other two: these are m and n.
    std::array<std::int64_t, 3> size = {std::abs(difference.q), std::abs(difference.r()), std::abs(difference.s)};
    std::sort(size.begin(), size.end());
    const auto n = static_cast<double>(size[0]);
    const auto m = static_cast<double>(size[1]);
    if (rings == 1)
        return m + n;
    if (rings == 2)
        return (m - n) + n * root3;
    return m >= 2 * n ? (m - 2 * n) + n * root7 : (m - n) * root7 + (2 * n - m) * root3;
}

}  // namespace seahex
