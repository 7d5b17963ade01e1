#include "seahex/geometry/HexRing.h"

#include <numeric>
#include <stdexcept>
#include <string>

namespace seahex
{

std::vector<RingOffset> ringOffsets(int rings)
{
    if (rings < 1 || rings > 3)
        throw std::domain_error("rings must be 1, 2 or 3, not " + std::to_string(rings));
    // the six neighbours counter-clockwise from east: side i of a ring leads from ring * step[i] towards step[i + 1]
    static constexpr HexCoord step[6] = {{1, 0}, {1, -1}, {0, -1}, {-1, 0}, {-1, 1}, {0, 1}};
    std::vector<RingOffset> offsets;
    for (int ring = 1; ring <= rings; ++ring)
        for (int side = 0; side < 6; ++side)
            for (int along = 0; along < ring; ++along)
            {
                const HexCoord offset = (ring - along) * step[side] + along * step[(side + 1) % 6];
                offsets.push_back({offset, ring, std::gcd(offset.q, offset.s) == 1});
            }
    return offsets;
}

}  // namespace seahex
