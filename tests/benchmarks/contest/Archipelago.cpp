#include "contest/Archipelago.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace seahex::contest
{
namespace
{

constexpr double landShare = 0.3;
constexpr double sizeExponent = 1.3;  // of the radius: twice that of the area
constexpr double raggedness = 0.2;

class Coast
{
public:
    Coast(double finest, std::uint64_t seed) : finest_(finest), engine_(seed) {}

    /// Evenly distributed in [0, 1).
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

    Polygon island(const Point &centre, double radius)
    {
        constexpr int corners = 8;
        std::vector<Point> points;
        const double stretch = 0.5 + 0.5 * unit();
        const double along = 2.0 * M_PI * unit();
        for (int k = 0; k < corners; ++k)
        {
            const double angle = 2.0 * M_PI * (k + 0.6 * unit()) / corners;
            const double reach = radius * (0.5 + 0.5 * unit());
            const Point round(reach * std::cos(angle), stretch * reach * std::sin(angle));
            points.push_back(centre + Point(std::cos(along) * round.x() - std::sin(along) * round.y(),
                                            std::sin(along) * round.x() + std::cos(along) * round.y()));
        }
        Polygon polygon;
        polygon.outer().push_back(points.front());
        for (std::size_t k = 0; k < points.size(); ++k)
            breakEdge(points[k], points[(k + 1) % points.size()], polygon.outer());
        return polygon;
    }

private:
    /// Appends the coast from a to b, without a.
    void breakEdge(const Point &a, const Point &b, Ring &ring)
    {
        const Point way = b - a;
        if (way.norm() <= finest_)
        {
            ring.push_back(b);
            return;
        }
        const double aside = raggedness * (2.0 * unit() - 1.0);
        const Point middle = 0.5 * (a + b) + aside * Point(-way.y(), way.x());
        breakEdge(a, middle, ring);
        breakEdge(middle, b, ring);
    }

    double finest_;
    std::mt19937_64 engine_;
};

}  // namespace

std::vector<Polygon> archipelago(const Box &box, double finest, std::uint64_t seed)
{
    Coast coast(finest, seed);
    const Point extent = box.max - box.min;
    const double largest = std::max(finest, extent.x() / 8.0);
    double land = landShare * extent.x() * extent.y();
    std::vector<Polygon> islands;
    while (land > 0.0)
    {
        const double radius = std::min(largest, finest * std::pow(1.0 - coast.unit(), -1.0 / sizeExponent));
        const double x = box.min.x() + extent.x() * coast.unit();
        const double y = box.min.y() + extent.y() * coast.unit();
        islands.push_back(coast.island({x, y}, radius));
        land -= radius * radius;  // about what the deformed circle covers
    }
    return islands;
}

}  // namespace seahex::contest
