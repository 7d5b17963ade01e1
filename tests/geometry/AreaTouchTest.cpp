#include "seahex/geometry/AreaTouch.h"

#include "support/Property.h"
#include "support/Random.h"

#include <ogr_geometry.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// A ring around a centre with corners on a coarse grid, so that shapes touch in corners and along edges again and
/// again.
Ring gridRing(const Point &centre, double radius)
{
    const int corners = *rc::gen::inRange(3, 12);
    Ring ring;
    for (int i = 0; i < corners; ++i)
    {
        const double angle = 2.0 * M_PI * (i + 0.5) / corners;
        const double reach = radius * *rc::gen::inRange(3, 11) / 10.0;
        ring.emplace_back(std::round(centre.x() + reach * std::cos(angle)),
                          std::round(centre.y() + reach * std::sin(angle)));
    }
    ring.push_back(ring.front());
    return ring;
}

Point gridPoint(int extent)
{
    return Point(*rc::gen::inRange(-extent, extent + 1), *rc::gen::inRange(-extent, extent + 1));
}

std::unique_ptr<OGRPolygon> toOgr(const Polygon &polygon)
{
    auto result = std::make_unique<OGRPolygon>();
    const auto add = [&result](const Ring &ring)
    {
        auto line = std::make_unique<OGRLinearRing>();
        for (const Point &p : ring)
            line->addPoint(p.x(), p.y());
        result->addRingDirectly(line.release());
    };
    add(polygon.outer());
    for (const Ring &hole : polygon.inners())
        add(hole);
    return result;
}

std::unique_ptr<OGRLineString> toOgr(const LineString &line)
{
    auto result = std::make_unique<OGRLineString>();
    for (const Point &p : line)
        result->addPoint(p.x(), p.y());
    return result;
}

bool intersects(const OGRGeometry &a, const OGRGeometry &b)
{
    return a.Intersects(&b) != FALSE;
}

/// A valid area with or without a hole, or none.
std::unique_ptr<Polygon> gridArea(const Point &centre, double radius)
{
    auto area = std::make_unique<Polygon>();
    area->outer() = gridRing(centre, radius);
    if (*rc::gen::arbitrary<bool>())
        area->inners().push_back(gridRing(centre, radius / 3.0));
    return toOgr(*area)->IsValid() ? std::move(area) : nullptr;
}

TEST(AreaTouch, agreesWithGeosOnPointsLinesAndAreas)
{
    checkProperty(400,
                  []
                  {
                      const auto area = gridArea(Point(0.0, 0.0), 12.0);
                      RC_PRE(static_cast<bool>(area));
                      const auto ogr = toOgr(*area);
                      const AreaTouch touch(*area);
                      for (int i = 0; i < 20; ++i)
                      {
                          const Point p = gridPoint(13);
                          RC_ASSERT(touch.touches(p) == intersects(*ogr, OGRPoint(p.x(), p.y())));
                      }
                      for (int i = 0; i < 10; ++i)
                      {
                          const LineString line{gridPoint(13), gridPoint(13), gridPoint(13)};
                          const bool isPoint = line[0] == line[1] && line[1] == line[2];
                          RC_PRE(!isPoint);
                          RC_ASSERT(touch.touches(Shape{{}, {line}, {}}) == intersects(*ogr, *toOgr(line)));
                      }
                      for (int i = 0; i < 10; ++i)
                      {
                          const auto other = gridArea(gridPoint(16), *rc::gen::inRange(2, 30));
                          if (other)
                              RC_ASSERT(touch.touches(Shape{{}, {}, {*other}}) == intersects(*ogr, *toOgr(*other)));
                      }
                  });
}

TEST(AreaTouch, tellsWhatDoublesCantFromItsBoundary)
{
    // On the diagonal a point with equal coordinates touches, and its neighbours among the doubles decide by one unit
    // in the last place, where the determinant in doubles is often 0 or of the wrong sign.
    Polygon area;
    area.outer() = {Point(0.0, 0.0), Point(48.0, 48.0), Point(0.0, 48.0), Point(0.0, 0.0)};
    const AreaTouch touch(area);
    checkProperty(2000,
                  [&touch]
                  {
                      const double at = *rc::gen::inRange(1, 1 << 30) / 22369621.4;
                      const double above = std::nextafter(at, 100.0);
                      RC_ASSERT(touch.touches(Point(at, at)));
                      RC_ASSERT(touch.touches(Point(at, above)));
                      RC_ASSERT(!touch.touches(Point(above, at)));
                  });
    // The same far from the origin, where differences of coordinates are rounded.
    Polygon sliver;
    sliver.outer() = {Point(0.1, 0.1), Point(12.0, 12.0), Point(24.0, 24.0), Point(0.1, 24.0), Point(0.1, 0.1)};
    EXPECT_TRUE(AreaTouch(sliver).touches(Point(0.5, 0.5)));
    EXPECT_TRUE(AreaTouch(sliver).touches(Point(0.5, std::nextafter(0.5, 1.0))));
    EXPECT_FALSE(AreaTouch(sliver).touches(Point(std::nextafter(0.5, 1.0), 0.5)));
}

TEST(AreaTouch, anAreaInAHoleTouchesOnlyAtTheHolesBoundary)
{
    Polygon area;
    area.outer() = {Point(0, 0), Point(10, 0), Point(10, 10), Point(0, 10), Point(0, 0)};
    area.inners() = {{Point(2, 2), Point(2, 8), Point(8, 8), Point(8, 2), Point(2, 2)}};
    const auto box = [](double low, double high)
    {
        Polygon square;
        square.outer() = {Point(low, low), Point(high, low), Point(high, high), Point(low, high), Point(low, low)};
        return Shape{{}, {}, {square}};
    };
    const AreaTouch touch(area);
    EXPECT_FALSE(touch.touches(box(3, 7)));
    EXPECT_TRUE(touch.touches(box(2, 7)));
    EXPECT_TRUE(touch.touches(box(-5, 20))) << "it lies within the other";
    EXPECT_FALSE(touch.touches(box(11, 12)));
    EXPECT_FALSE(touch.touches(Shape()));
    EXPECT_FALSE(AreaTouch(Polygon()).touches(box(0, 1)));
}

}  // namespace
