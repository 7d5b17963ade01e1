#include "seahex/geometry/AreaTouch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace seahex
{
namespace
{

/// The sign of a sum of products, exact: an expansion is grown term by term ([Shewchuk1997], fig. 4 and 6).
class ExactSum
{
public:
    void addProduct(double x, double y)
    {
        const double product = x * y;
        add(std::fma(x, y, -product));
        add(product);
    }

    int sign() const
    {
        // terms do not overlap and grow in magnitude: the last one that is not 0 outweighs the others
        for (std::size_t i = count_; i > 0; --i)
            if (terms_[i - 1] != 0.0)
                return terms_[i - 1] > 0.0 ? 1 : -1;
        return 0;
    }

private:
    void add(double value)
    {
        for (std::size_t i = 0; i < count_; ++i)
        {
            const double sum = value + terms_[i];
            const double virtualTerm = sum - value;
            terms_[i] = (value - (sum - virtualTerm)) + (terms_[i] - virtualTerm);
            value = sum;
        }
        terms_[count_++] = value;
    }

    std::array<double, 12> terms_{};
    std::size_t count_ = 0;
};

/// On which side of the line from a to b the point c lies: 1 left, -1 right, 0 on it. Exact but for underflow.
int sideOf(const Point &a, const Point &b, const Point &c)
{
    const double left = (a.x() - c.x()) * (b.y() - c.y());
    const double right = (a.y() - c.y()) * (b.x() - c.x());
    const double difference = left - right;
    constexpr double relativeError = 3.3306690738754716e-16;  // (3 + 16 eps) eps, eps = 2^-53
    if (std::abs(difference) > relativeError * (std::abs(left) + std::abs(right)))
        return difference > 0.0 ? 1 : -1;
    ExactSum sum;
    sum.addProduct(a.x(), b.y());
    sum.addProduct(-a.x(), c.y());
    sum.addProduct(-c.x(), b.y());
    sum.addProduct(-a.y(), b.x());
    sum.addProduct(a.y(), c.x());
    sum.addProduct(c.y(), b.x());
    return sum.sign();
}

bool rangesMeet(double a, double b, double c, double d)
{
    return std::max(a, b) >= std::min(c, d) && std::max(c, d) >= std::min(a, b);
}

bool segmentsMeet(const Point &a, const Point &b, const Point &c, const Point &d)
{
    // collinear segments meet if their boxes do
    return rangesMeet(a.y(), b.y(), c.y(), d.y()) && rangesMeet(a.x(), b.x(), c.x(), d.x()) &&
           sideOf(a, b, c) * sideOf(a, b, d) <= 0 && sideOf(c, d, a) * sideOf(c, d, b) <= 0;
}

constexpr std::size_t EDGES_PER_STRIP = 32;

std::size_t edgeCount(const Ring &ring)
{
    return ring.empty() ? 0 : ring.size() - 1;
}

}  // namespace

/// Monotone in y, so that ranges of y that meet have a strip in common, however it is rounded.
inline std::size_t AreaTouch::stripOf(double y) const
{
    const double strip = std::clamp((y - south_) * stripsPerUnit_, 0.0, static_cast<double>(stripStart_.size() - 2));
    return static_cast<std::size_t>(static_cast<std::int64_t>(strip));
}

/// Calls for every edge in every strip that it meets.
template <class Visit>
void AreaTouch::forEachEdge(Visit &&visit) const
{
    const auto ofRing = [&](const Ring &ring)
    {
        std::size_t from = ring.empty() ? 0 : stripOf(ring.front().y());
        for (std::size_t i = 1; i < ring.size(); ++i)
        {
            const std::size_t to = stripOf(ring[i].y());
            for (std::size_t strip = std::min(from, to); strip <= std::max(from, to); ++strip)
                visit(&ring[i - 1], strip);
            from = to;
        }
    };
    ofRing(area_.outer());
    for (const Ring &hole : area_.inners())
        ofRing(hole);
}

AreaTouch::AreaTouch(const Polygon &area) : area_(area)
{
    std::size_t count = edgeCount(area.outer());
    for (const Ring &hole : area.inners())
        count += edgeCount(hole);
    double north = 0.0;
    if (!area.outer().empty())
    {
        const auto ends = std::minmax_element(area.outer().begin(), area.outer().end(),
                                              [](const Point &a, const Point &b) { return a.y() < b.y(); });
        south_ = ends.first->y();
        north = ends.second->y();
    }
    const std::size_t strips = count / EDGES_PER_STRIP + 1;
    if (north > south_)
        stripsPerUnit_ = static_cast<double>(strips) / (north - south_);

    // Counting sort: count, sum up, place from the end.
    stripStart_.assign(strips + 1, 0);
    forEachEdge([this](const Point *, std::size_t strip) { ++stripStart_[strip]; });
    std::size_t total = 0;
    for (std::size_t &start : stripStart_)
        start = total += start;
    edges_.resize(total);
    forEachEdge([this](const Point *edge, std::size_t strip) { edges_[--stripStart_[strip]] = edge; });
}

AreaTouch::Place AreaTouch::locate(const Point &p) const
{
    const std::size_t strip = stripOf(p.y());
    bool inside = false;
    for (std::size_t i = stripStart_[strip]; i < stripStart_[strip + 1]; ++i)
    {
        const Point &a = edges_[i][0];
        const Point &b = edges_[i][1];
        if (std::max(a.y(), b.y()) < p.y() || std::min(a.y(), b.y()) > p.y() || std::max(a.x(), b.x()) < p.x())
            continue;
        // a ray to the east crosses the edge if just one of its ends lies above the ray
        const bool spans = (a.y() > p.y()) != (b.y() > p.y());
        if (std::min(a.x(), b.x()) > p.x())
        {
            inside = inside != spans;
            continue;
        }
        const int side = sideOf(a, b, p);
        if (side == 0)
            return Place::Boundary;
        if (spans && (side > 0) == (b.y() > a.y()))
            inside = !inside;
    }
    return inside ? Place::Inside : Place::Outside;
}

bool AreaTouch::boundaryMeets(const Point &a, const Point &b) const
{
    const auto [first, last] = std::minmax({stripOf(a.y()), stripOf(b.y())});
    for (std::size_t i = stripStart_[first]; i < stripStart_[last + 1]; ++i)
        if (segmentsMeet(a, b, edges_[i][0], edges_[i][1]))
            return true;
    return false;
}

template <class Path>
bool AreaTouch::boundaryMeetsPath(const Path &path) const
{
    for (std::size_t i = 1; i < path.size(); ++i)
        if (boundaryMeets(path[i - 1], path[i]))
            return true;
    return false;
}

/// Areas whose boundaries do not meet have a point in common only if one lies in the other, and then all of its outer
/// ring does.
bool AreaTouch::touchesArea(const Polygon &other) const
{
    if (area_.outer().empty() || other.outer().empty())
        return false;
    if (touches(other.outer().front()) || boundaryMeetsPath(other.outer()))
        return true;
    for (const Ring &hole : other.inners())
        if (boundaryMeetsPath(hole))
            return true;
    return AreaTouch(other).touches(area_.outer().front());
}

bool AreaTouch::touches(const Point &p) const
{
    return locate(p) != Place::Outside;
}

bool AreaTouch::touches(const Shape &shape) const
{
    for (const Point &point : shape.points)
        if (touches(point))
            return true;
    for (const LineString &line : shape.lines)
        if (!line.empty() && (touches(line.front()) || boundaryMeetsPath(line)))
            return true;
    return std::any_of(shape.areas.begin(), shape.areas.end(),
                       [this](const Polygon &area) { return touchesArea(area); });
}

}  // namespace seahex
