#include "support/RationalSeabed.h"

#include <algorithm>
#include <cmath>

namespace seahex::test
{
namespace
{

/// The whole number at or below.
std::int64_t floorOf(const Rational &value)
{
    using boost::multiprecision::cpp_int;
    const cpp_int n = boost::multiprecision::numerator(value);
    const cpp_int d = boost::multiprecision::denominator(value);
    cpp_int quotient = n / d;
    if (n < 0 && quotient * d != n)
        --quotient;
    return static_cast<std::int64_t>(quotient);
}

/// Narrows [enter, leave] to where low <= from + t by <= high.
void clip(const Rational &from, const Rational &by, const Rational &low, const Rational &high, Rational &enter,
          Rational &leave)
{
    if (by == 0)
    {
        if (from < low || from > high)
            leave = enter - 1;
        return;
    }
    Rational first = (low - from) / by;
    Rational last = (high - from) / by;
    if (last < first)
        std::swap(first, last);
    enter = std::max(enter, first);
    leave = std::min(leave, last);
}

}  // namespace

RationalSeabed::RationalSeabed(const Bathymetry &seabed)
    : seabed_(seabed), lastColumn_(seabed.grid().columns() - 1), lastRow_(seabed.grid().rows() - 1)
{
}

RationalSeabed::Place RationalSeabed::steps(const Point &p) const
{
    const NodeGrid &grid = seabed_.grid();
    return {(Rational(p.x()) - Rational(grid.southWest().x())) / Rational(grid.spacing().x()),
            (Rational(p.y()) - Rational(grid.southWest().y())) / Rational(grid.spacing().y())};
}

bool RationalSeabed::isOutside(const Place &p) const
{
    return p.x < 0 || p.y < 0 || p.x > lastColumn_ || p.y > lastRow_;
}

bool RationalSeabed::touchesUnknown(const Place &a, const Place &b) const
{
    for (std::int64_t row = 0; row < lastRow_; ++row)
        for (std::int64_t column = 0; column < lastColumn_; ++column)
        {
            bool known = true;
            for (const std::int64_t corner : {0, 1, 2, 3})
                known = known && std::isfinite(seabed_.nodeDepth(column + (corner & 1), row + (corner >> 1)));
            if (known)
                continue;
            Rational enter = 0;
            Rational leave = 1;
            clip(a.x, b.x - a.x, column, column + 1, enter, leave);
            if (leave >= enter)
                clip(a.y, b.y - a.y, row, row + 1, enter, leave);
            if (leave >= enter)
                return true;
        }
    return false;
}

Rational RationalSeabed::depth(const Place &p) const
{
    Rational sum = 0;
    const std::int64_t column = std::min(floorOf(p.x), lastColumn_ - 1);
    const std::int64_t row = std::min(floorOf(p.y), lastRow_ - 1);
    for (std::int64_t j = row; j <= row + 1; ++j)
        for (std::int64_t i = column; i <= column + 1; ++i)
        {
            const Rational weightX = 1 - abs(p.x - i);
            const Rational weightY = 1 - abs(p.y - j);
            sum += weightX * weightY * Rational(static_cast<double>(seabed_.nodeDepth(i, j)));
        }
    return sum;
}

std::optional<Rational> RationalSeabed::leastWaterBelow(const Point3 &a, const Point3 &b) const
{
    const Place from = steps(horizontal(a));
    const Place to = steps(horizontal(b));
    if (isOutside(from) || isOutside(to) || touchesUnknown(from, to))
        return std::nullopt;
    const Place by{to.x - from.x, to.y - from.y};
    std::vector<Rational> cuts = {0, 1};
    const auto cut = [&cuts](const Rational &start, const Rational &step, std::int64_t last)
    {
        for (std::int64_t line = 0; step != 0 && line <= last; ++line)
        {
            const Rational t = (line - start) / step;
            if (t > 0 && t < 1)
                cuts.push_back(t);
        }
    };
    cut(from.x, by.x, lastColumn_);
    cut(from.y, by.y, lastRow_);
    std::sort(cuts.begin(), cuts.end());

    const auto water = [&](const Rational &t) -> Rational
    {
        return depth({from.x + t * by.x, from.y + t * by.y}) - Rational(a.z()) -
               t * (Rational(b.z()) - Rational(a.z()));
    };
    Rational least = std::min(water(0), water(1));
    for (std::size_t i = 1; i < cuts.size(); ++i)
    {
        // A quadratic in s = 0 .. 1 between two cuts, by three of its values: f0 + p s + q s^2.
        const Rational length = cuts[i] - cuts[i - 1];
        const Rational first = water(cuts[i - 1]);
        const Rational middle = water(cuts[i - 1] + length / 2);
        const Rational last = water(cuts[i]);
        const Rational q = 2 * first - 4 * middle + 2 * last;
        const Rational p = last - first - q;
        least = std::min({least, first, last});
        if (q > 0 && -p > 0 && -p < 2 * q)
            least = std::min<Rational>(least, first - p * p / (4 * q));
    }
    return least;
}

std::optional<Rational> RationalSeabed::leastDepth(const Box &box) const
{
    const Place low = steps(box.min);
    const Place high = steps(box.max);
    if (isOutside(low) || isOutside(high))
        return std::nullopt;
    const auto stations = [](const Rational &first, const Rational &last)
    {
        std::vector<Rational> all = {first, last};
        for (std::int64_t line = floorOf(first); line <= last; ++line)
            if (line > first)
                all.push_back(line);
        return all;
    };
    std::optional<Rational> least;
    for (const Rational &y : stations(low.y, high.y))
    {
        if (touchesUnknown({low.x, y}, {high.x, y}))
            return std::nullopt;
        for (const Rational &x : stations(low.x, high.x))
        {
            const Rational here = depth({x, y});
            least = least ? std::min(*least, here) : here;
        }
    }
    return least;
}

}  // namespace seahex::test
