#pragma once

#include <seahex/geometry/HexCoord.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

namespace seahex
{

/// Lengths of ring jumps as whole numbers of a small unit, so that sums have no rounding and equal lengths are equal.
///
/// A pitch is 73,917 units: with so many root 3 and root 7 are almost whole, too. A length in units is true to 4e-9 of
/// itself, that of any chain of jumps likewise; paths that differ by less may be taken for each other.
namespace units
{

constexpr std::int64_t pitch = 73917;
constexpr std::int64_t root3 = 128028;
constexpr std::int64_t root7 = 195566;

/// By how much, at most, a length in units is false, as a share of it.
constexpr double error = 4e-9;

/// ringNorm() in units: exact, and therefore a consistent bound of chains of jumps. Their lengths are those above, so
/// it is the larger of two linear forms of m >= n >= 0, the coordinates along the two nearest neighbours' directions.
class RingNorm
{
public:
    /// @param rings  1, 2 or 3
    explicit constexpr RingNorm(int rings)
        : alongM_{pitch, rings == 3 ? root7 - root3 : pitch}, alongN_{rings == 1   ? pitch
                                                                      : rings == 2 ? root3 - pitch
                                                                                   : root7 - 2 * pitch,
                                                                      rings == 1   ? pitch
                                                                      : rings == 2 ? root3 - pitch
                                                                                   : 2 * root3 - root7}
    {
    }

    /// @param q, s  cube coordinates of a difference
    std::int64_t operator()(std::int32_t q, std::int32_t s) const
    {
        const std::int32_t a = std::abs(q);
        const std::int32_t b = std::abs(s);
        const std::int32_t c = std::abs(q + s);
        const std::int64_t n = std::min(a, std::min(b, c));
        const std::int64_t m = std::max(a, std::max(b, c)) - n;
        return std::max(alongM_[0] * m + alongN_[0] * n, alongM_[1] * m + alongN_[1] * n);
    }

private:
    std::array<std::int64_t, 2> alongM_;
    std::array<std::int64_t, 2> alongN_;
};

}  // namespace units

}  // namespace seahex
