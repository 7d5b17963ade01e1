#include <seahex/world/RaisedSeabed.h>

#include "support/RandomShapes.h"
#include "support/Seabeds.h"

#include <boost/geometry/algorithms/covered_by.hpp>
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// 100 m of water over 5 x 4 nodes, 10 m from west to east and 20 m from south to north.
Bathymetry plain()
{
    return Bathymetry(NodeGrid(Point(1000, 2000), Point(10, 20), 5, 4), std::vector<float>(20, 100.0F));
}

LyingObject cable(const Point &a, const Point &b, double radius = 0.0)
{
    LyingObject object;
    object.shape.lines = {LineString{a, b}};
    object.radius = radius;
    return object;
}

/// The nodes of a seabed as text, from the north: '.' 100 m, '#' 93 m, '=' 40 m.
std::string mapOf(const Bathymetry &seabed)
{
    std::string text;
    for (std::int64_t row = seabed.grid().rows() - 1; row >= 0; --row)
    {
        for (std::int64_t column = 0; column < seabed.grid().columns(); ++column)
        {
            const float depth = seabed.nodeDepth(column, row);
            text += depth == 100.0F ? '.' : depth == 93.0F ? '#' : depth == 40.0F ? '=' : '?';
        }
        text += '\n';
    }
    return text;
}

/// The same seabed with other spacing: as many metres between columns as between rows seldom are.
Bathymetry randomGrid(Random &random)
{
    const auto model = randomSeabed(random, random.integer(2, 9), random.integer(2, 9), 0.05);
    std::vector<float> depths;
    for (std::int64_t row = 0; row < model->grid().rows(); ++row)
        for (std::int64_t column = 0; column < model->grid().columns(); ++column)
            depths.push_back(model->nodeDepth(column, row));
    return Bathymetry(NodeGrid(Point(random.real(-1e5, 1e5), random.real(-1e5, 1e5)),
                               Point(random.real(1.0, 30.0), random.real(1.0, 30.0)), model->grid().columns(),
                               model->grid().rows()),
                      std::move(depths));
}

LyingObject randomObject(Random &random, const Box &around)
{
    LyingObject object;
    const double size = (around.max - around.min).norm();
    switch (random.integer(0, 2))
    {
        case 0:
            object.shape.points.push_back(random.pointIn(around));
            break;
        case 1:
            object.shape.lines.push_back({random.pointIn(around), random.pointIn(around), random.pointIn(around)});
            break;
        default:
            object.shape.areas.push_back(randomArea(random, random.pointIn(around), 0.3 * size, random.chance(0.5)));
    }
    if (random.chance(0.5))
        object.radius = random.real(0.0, 0.1 * size);
    if (random.chance(0.3))
        object.leastDepthM = random.real(-5.0, 60.0);
    return object;
}

double distanceTo(const Shape &shape, const Point &p)
{
    double least = INFINITY;
    for (const Point &point : shape.points)
        least = std::min(least, (p - point).norm());
    for (const LineString &line : shape.lines)
        least = std::min(least, boost::geometry::distance(p, line));
    for (const Polygon &area : shape.areas)
        least = std::min(least, boost::geometry::distance(p, area));
    return least;
}

}  // namespace

TEST(RaisedSeabed, raisesAllNodesOfTouchedCellsAndNoOthers)
{
    EXPECT_EQ(mapOf(*raisedSeabed(plain(), {cable(Point(1012, 2025), Point(1018, 2035))}, 7.0)), ".....\n"
                                                                                                 ".##..\n"
                                                                                                 ".##..\n"
                                                                                                 ".....\n");
    EXPECT_EQ(mapOf(*raisedSeabed(plain(), {cable(Point(1012, 2025), Point(1018, 2035), 2.4)}, 7.0)), ".....\n"
                                                                                                      "####.\n"
                                                                                                      "####.\n"
                                                                                                      ".....\n")
        << "2.4 m to either side";
    EXPECT_EQ(mapOf(*raisedSeabed(plain(), {cable(Point(900, 2010), Point(1025, 2010))}, 7.0)), ".....\n"
                                                                                                ".....\n"
                                                                                                "####.\n"
                                                                                                "####.\n")
        << "begins outside";
    EXPECT_EQ(mapOf(*raisedSeabed(plain(), {}, 7.0)), mapOf(plain()));
}

TEST(RaisedSeabed, knowsACablesOwnDepth)
{
    LyingObject hanging = cable(Point(1012, 2025), Point(1018, 2035));
    hanging.leastDepthM = 47.0;
    const LyingObject lying = cable(Point(1002, 2025), Point(1018, 2035));
    EXPECT_EQ(mapOf(*raisedSeabed(plain(), {lying, hanging}, 7.0)), ".....\n"
                                                                    "#==..\n"
                                                                    "#==..\n"
                                                                    ".....\n");
    hanging.leastDepthM = 200.0;
    EXPECT_EQ(raisedSeabed(plain(), {hanging}, 7.0)->nodeDepth(1, 1), 93.0F) << "deeper than the seabed: buried";
    hanging.leastDepthM = std::nan("");
    EXPECT_EQ(raisedSeabed(plain(), {hanging}, 7.0)->nodeDepth(1, 1), 93.0F);
}

TEST(RaisedSeabed, refusesWhatIsNoHeightAndNoPlace)
{
    for (const double height : {-1.0, std::nan(""), static_cast<double>(INFINITY)})
        EXPECT_THROW(raisedSeabed(plain(), {}, height), std::domain_error);
    EXPECT_THROW(raisedSeabed(plain(), {cable(Point(std::nan(""), 0), Point(0, 0))}, 1.0), std::domain_error);
}

TEST(RaisedSeabed, isHigherWhereverAnObjectMayLieAndNowhereDeeper)
{
    int near = 0;
    int untouched = 0;
    forEachSeed(300,
                [&](Random &random)
                {
                    const Bathymetry bare = randomGrid(random);
                    const Box &bounds = bare.grid().bounds();
                    const Point beyond = 0.2 * (bounds.max - bounds.min);
                    std::vector<LyingObject> objects;
                    for (std::int64_t i = random.integer(1, 3); i > 0; --i)
                        objects.push_back(randomObject(random, {bounds.min - beyond, bounds.max + beyond}));
                    const double height = random.real(0.0, 20.0);
                    const auto raised = raisedSeabed(bare, objects, height);
                    const Point &spacing = bare.grid().spacing();
                    for (int i = 0; i < 200; ++i)
                    {
                        const Point p = random.pointIn(bounds);
                        const Point corner = bare.grid().steps(p).array().floor();
                        const auto inCell = [&]
                        {
                            return Point((corner + Point(random.unit(), random.unit())).cwiseProduct(spacing) +
                                         bare.grid().southWest());
                        };
                        const double before = bare.depthAt(p);
                        const double after = raised->depthAt(p);
                        ASSERT_EQ(std::isfinite(before), std::isfinite(after));
                        if (!std::isfinite(before))
                            continue;
                        ASSERT_LE(after, before);
                        bool isFar = true;
                        for (const LyingObject &object : objects)
                        {
                            // another point of the same cell at which the object may lie
                            const double distance = distanceTo(object.shape, inCell());
                            isFar = isFar && distance > 2.0 * spacing.norm() +
                                                            object.radius * spacing.maxCoeff() / spacing.minCoeff() +
                                                            1e-3;
                            if (distance > object.radius)
                                continue;
                            ++near;
                            ASSERT_LE(after, before - height + 1e-9);
                            ASSERT_LE(after, object.leastDepthM.value_or(INFINITY) - height + 1e-9);
                        }
                        if (isFar)
                        {
                            ++untouched;
                            ASSERT_EQ(after, before);
                        }
                    }
                });
    EXPECT_GT(near, 1000);
    EXPECT_GT(untouched, 1000);
}
