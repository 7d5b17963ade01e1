#include "support/RandomShapes.h"

#include <algorithm>
#include <cmath>

namespace seahex::test
{

Ring randomRing(Random &random, const Point &centre, double radius)
{
    // Corners in all directions, less than half a turn apart, at any distance: seen from the centre each edge is whole.
    const std::int64_t corners = random.integer(4, 14);
    const double squeeze = random.chance(0.3) ? std::pow(10.0, random.real(-6.0, 0.0)) : 1.0;
    const double turn = random.real(0.0, 2 * M_PI);
    const Point along(std::cos(turn), std::sin(turn));
    const Point across(-along.y(), along.x());
    Ring ring;
    for (std::int64_t i = 0; i < corners; ++i)
    {
        const double angle = 2 * M_PI * (static_cast<double>(i) + random.real(0.0, 0.9)) / static_cast<double>(corners);
        const double distance = radius * random.real(0.2, 1.0);
        ring.push_back(centre + distance * (std::cos(angle) * along + squeeze * std::sin(angle) * across));
    }
    ring.push_back(ring.front());
    if (random.chance(0.5))
        std::reverse(ring.begin(), ring.end());
    return ring;
}

Ring ringWithin(Random &random, const Ring &ring, const Point &centre)
{
    // every corner moved towards the centre stays in the triangle that it and its neighbours form with the centre
    Ring inner;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
        inner.push_back(centre + random.real(0.4, 0.9) * (ring[i] - centre));
    inner.push_back(inner.front());
    if (random.chance(0.5))
        std::reverse(inner.begin(), inner.end());
    return inner;
}

Polygon randomArea(Random &random, const Point &centre, double radius, bool withHole, Polygon *island)
{
    Polygon area;
    area.outer() = randomRing(random, centre, radius);
    if (withHole)
        area.inners().push_back(ringWithin(random, area.outer(), centre));
    if (withHole && island != nullptr)
        island->outer() = ringWithin(random, area.inners().front(), centre);
    return area;
}

Ring crossedRing(Random &random, const Box &box)
{
    Ring ring;
    for (std::int64_t i = random.integer(4, 12); i > 0; --i)
        ring.push_back(random.pointIn(box));
    ring.push_back(ring.front());
    return ring;
}

}  // namespace seahex::test
