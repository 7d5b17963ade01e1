#include "seahex/search/NormCones.h"

#include <algorithm>
#include <cmath>

namespace seahex
{
namespace
{

double course(HexCoord jump)
{
    const auto s = static_cast<double>(jump.s);
    return std::atan2(0.5 * std::sqrt(3.0) * s, static_cast<double>(jump.q) + 0.5 * s);
}

std::int32_t narrow(std::int64_t coordinate)
{
    return static_cast<std::int32_t>(coordinate);
}

}  // namespace

NormCones::NormCones(int rings, const std::vector<HexCoord> &jumps)
{
    const units::RingNorm norm(rings);
    std::vector<HexCoord> sides = jumps;
    std::sort(sides.begin(), sides.end(), [](HexCoord a, HexCoord b) { return course(a) < course(b); });
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
        const HexCoord a = sides[i];
        const HexCoord b = sides[(i + 1) % sides.size()];
        // the determinants of (a, v) and (v, b), both positive for v between the two
        Cone cone{narrow(-a.s), narrow(a.q), narrow(b.s), narrow(-b.q), {}};
        const HexCoord far = 16 * (a + b);
        for (std::size_t k = 0; k < jumps.size(); ++k)
        {
            const HexCoord left = far - jumps[k];
            cone.added[k] =
                static_cast<std::uint32_t>(norm(narrow(jumps[k].q), narrow(jumps[k].s)) +
                                           norm(narrow(left.q), narrow(left.s)) - norm(narrow(far.q), narrow(far.s)));
        }
        cones_.push_back(cone);
    }
}

const NormCones::Cone *NormCones::find(std::int32_t q, std::int32_t s) const
{
    const auto cone = std::find_if(cones_.begin(), cones_.end(), [q, s](const Cone &c) { return c.holds(q, s); });
    return cone == cones_.end() ? nullptr : &*cone;
}

}  // namespace seahex
