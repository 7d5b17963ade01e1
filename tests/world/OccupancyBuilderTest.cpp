#include <seahex/world/OccupancyBuilder.h>
#include <seahex/world/SegmentValidity.h>

#include "support/AsciiWorld.h"
#include "support/LatticeKinds.h"
#include "support/RandomShapes.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

using namespace seahex;
using namespace seahex::test;

namespace
{

template <class LatticeType>
double largestCoordinate(const LatticeType &lattice, const Shape &shape)
{
    double largest = std::max(lattice.northWest().cwiseAbs().maxCoeff(), lattice.pitch());
    for (const Point &p : shape.points)
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    forEachSegment(shape,
                   [&largest](const Point &a, const Point &b) {
                       largest = std::max({largest, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()});
                   });
    return largest;
}

template <class LatticeType>
std::shared_ptr<const LatticeOccupancy<LatticeType>> blockedBy(const LatticeType &lattice, const Shape &shape,
                                                               double radius)
{
    OccupancyBuilder builder(lattice);
    builder.block(shape, radius);
    return builder.build();
}

/// Each cell: blocked if it is within the radius of the shape, free if it is farther than that and the tolerance.
template <class LatticeType>
std::string judge(const LatticeType &lattice, const Shape &shape, double radius)
{
    const auto occupancy = blockedBy(lattice, shape, radius);
    const CellOracle<LatticeType> oracle(lattice);
    const double tolerance = 1e-9 * largestCoordinate(lattice, shape);
    std::string verdict;
    forEachCell(lattice, 0,
                [&](typename LatticeType::Cell cell)
                {
                    const long double distance = oracle.distance(shape, cell);
                    const bool blocked = occupancy->isBlocked(cell);
                    if (blocked ? distance > radius + tolerance : distance <= radius)
                        verdict = std::string(blocked ? "blocked" : "free") + " at a distance of " +
                                  std::to_string(static_cast<double>(distance)) + ", radius " + std::to_string(radius) +
                                  ", column " + std::to_string(toOffset(cell).column) + " row " +
                                  std::to_string(toOffset(cell).row);
                });
    return verdict;
}

template <class LatticeType>
LatticeType smallLattice(Random &random)
{
    const double pitch = std::pow(10.0, random.real(-3.0, 2.0));
    const Point origin = pitch * random.pointIn({Point(-40, -40), Point(40, 40)});
    return {origin, pitch, random.integer(1, 24), random.integer(1, 16)};
}

double anyRadius(Random &random, double pitch)
{
    return random.chance(0.5) ? 0.0 : pitch * std::pow(10.0, random.real(-4.0, 0.7));
}

/// A point in or somewhat beyond the lattice.
template <class LatticeType>
Point around(Random &random, const LatticeType &lattice)
{
    const Box box = lattice.bounds();
    const Point margin(3.0 * lattice.pitch(), 3.0 * lattice.pitch());
    return random.pointIn({box.min - margin, box.max + margin});
}

Ring ringOf(std::initializer_list<Point> points)
{
    Ring ring(points.begin(), points.end());
    ring.push_back(ring.front());
    return ring;
}

template <class LatticeType>
class OccupancyBuilderOf : public ::testing::Test
{
};

TYPED_TEST_SUITE(OccupancyBuilderOf, LatticeKinds, LatticeKindNames);

}  // namespace

TYPED_TEST(OccupancyBuilderOf, areasWithLakesAndIslands)
{
    for (std::uint64_t seed = 1; seed <= 1500; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice = smallLattice<TypeParam>(random);
        Shape shape;
        Polygon island;
        const double size = lattice.pitch() * std::pow(10.0, random.real(-1.5, 1.3));
        shape.areas.push_back(randomArea(random, around(random, lattice), size, random.chance(0.6), &island));
        if (!island.outer().empty())
            shape.areas.push_back(island);
        ASSERT_EQ(judge(lattice, shape, anyRadius(random, lattice.pitch())), "");
    }
}

TYPED_TEST(OccupancyBuilderOf, pointsAndLines)
{
    for (std::uint64_t seed = 1; seed <= 1500; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice = smallLattice<TypeParam>(random);
        Shape shape;
        for (std::int64_t i = random.integer(0, 3); i > 0; --i)
            shape.points.push_back(random.chance(0.5) ? random.pointOf(lattice, random.cellOf(lattice))
                                                      : around(random, lattice));
        LineString line;
        for (std::int64_t i = random.integer(0, 4); i > 0; --i)
            line.push_back(around(random, lattice));
        if (line.size() != 1)  // lines of one point are tested by themselves
            shape.lines.push_back(line);
        ASSERT_EQ(judge(lattice, shape, anyRadius(random, lattice.pitch())), "");
    }
}

TYPED_TEST(OccupancyBuilderOf, ringsThatCrossThemselvesBlockTooMuchRatherThanTooLittle)
{
    for (std::uint64_t seed = 1; seed <= 600; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice({-7.0, 3.0}, 1.0, 20, 16);
        Shape shape;
        shape.areas.resize(1);
        shape.areas[0].outer() = crossedRing(random, lattice.bounds());
        if (random.chance(0.3))
            shape.areas[0].inners().push_back(crossedRing(random, lattice.bounds()));
        const double radius = anyRadius(random, 1.0);
        const auto occupancy = blockedBy(lattice, shape, radius);
        const CellOracle<TypeParam> oracle(lattice);
        forEachCell(lattice, 0,
                    [&](typename TypeParam::Cell cell)
                    { ASSERT_TRUE(occupancy->isBlocked(cell) || oracle.distance(shape, cell) > radius); });
    }
}

TYPED_TEST(OccupancyBuilderOf, cellsTouchedInAnEdgeOrACornerAreBlocked)
{
    const TypeParam lattice({100.0, 200.0}, 2.0, 9, 9);
    const auto cell = TypeParam::cell({4, 4});
    const auto corners = lattice.corners(cell);
    constexpr std::size_t atCorner = cellsAtCorner<TypeParam>;
    const std::size_t cornerCount = corners.size();
    for (std::size_t i = 0; i < cornerCount; ++i)
    {
        Shape corner;
        corner.points = {corners[i]};
        EXPECT_EQ(blockedBy(lattice, corner, 0.0)->blockedCount(), static_cast<std::int64_t>(atCorner))
            << "corner " << i;
        Shape edge;
        edge.lines = {LineString{corners[i], corners[(i + 1) % cornerCount]}};
        EXPECT_EQ(blockedBy(lattice, edge, 0.0)->blockedCount(), static_cast<std::int64_t>(2 * atCorner - 2))
            << "edge " << i;
    }
    // the cell itself as an area: it and all that touch it
    Shape area;
    area.areas.resize(1);
    area.areas[0].outer().assign(corners.begin(), corners.end());
    area.areas[0].outer().push_back(corners[0]);
    EXPECT_EQ(blockedBy(lattice, area, 0.0)->blockedCount(), atCorner == 3 ? 7 : 9);
}

TEST(OccupancyBuilder, aReefThinnerThanACellIsNotLost)
{
    // A millimetre wide, between two columns of centres of cells 1 m wide: no centre lies in it.
    const HexLattice lattice(Point::Zero(), 1.0, 8, 5);
    const Box box = lattice.bounds();
    Shape reef;
    reef.areas.resize(1);
    reef.areas[0].outer() = ringOf({Point(4.2, box.min.y() - 1), Point(4.201, box.min.y() - 1),
                                    Point(4.201, box.max.y() + 1), Point(4.2, box.max.y() + 1)});
    const auto occupancy = blockedBy(lattice, reef, 0.0);
    EXPECT_EQ(toPicture(*occupancy), R"(
 . . . # . . . .
. . . . # . . .
 . . . # . . . .
. . . . # . . .
 . . . # . . . .
)");
    for (std::int64_t row = 0; row < 5; ++row)
        EXPECT_FALSE(isFree(*occupancy, lattice.centre(toCube({1, row})), lattice.centre(toCube({6, row}))));
}

TEST(OccupancyBuilder, aRadiusIsRound)
{
    // A point danger at a centre. Of the cells two steps away, those north and south lie root 3 pitches away, with a
    // corner towards the danger; those due east lie 2 pitches away, with an edge 1.5 pitches from it.
    const HexLattice lattice(Point::Zero(), 1.0, 9, 7);
    Shape danger;
    danger.points = {lattice.centre(toCube({4, 3}))};
    EXPECT_EQ(toPicture(*blockedBy(lattice, danger, 1.49)), R"(
 . . . . . . . . .
. . . . # . . . .
 . . # # # # . . .
. . . # # # . . .
 . . # # # # . . .
. . . . # . . . .
 . . . . . . . . .
)");
    EXPECT_EQ(toPicture(*blockedBy(lattice, danger, 1.51)), R"(
 . . . . . . . . .
. . . # # # . . .
 . . # # # # . . .
. . # # # # # . .
 . . # # # # . . .
. . . # # # . . .
 . . . . . . . . .
)");
}

TYPED_TEST(OccupancyBuilderOf, degenerateShapesBlockWhatTheyTouch)
{
    const TypeParam lattice(Point::Zero(), 1.0, 9, 9);
    const Point p = lattice.centre(TypeParam::cell({4, 4}));
    Shape point;
    point.points = {p};
    for (const double radius : {0.0, 1.2})
    {
        const auto expected = blockedBy(lattice, point, radius)->words();
        EXPECT_GT(blockedBy(lattice, point, radius)->blockedCount(), 0);
        for (const std::size_t repeats : {1, 2, 3, 4})
        {
            Shape line;
            line.lines.resize(1);
            line.lines[0].assign(repeats, p);
            EXPECT_EQ(blockedBy(lattice, line, radius)->words(), expected)
                << "a line of " << repeats << " equal points";
            Shape area;
            area.areas.resize(1);
            area.areas[0].outer().assign(repeats, p);
            EXPECT_EQ(blockedBy(lattice, area, radius)->words(), expected)
                << "a ring of " << repeats << " equal points";
        }
    }
    Shape nothing;
    nothing.lines.resize(1);
    nothing.areas.resize(1);
    EXPECT_EQ(blockedBy(lattice, nothing, 1.0)->blockedCount(), 0);
}

TYPED_TEST(OccupancyBuilderOf, whatLiesFarAwayBlocksNothingAndWhatComesFromThereDoes)
{
    const TypeParam lattice(Point::Zero(), 1.0, 9, 9);
    Shape far;
    far.points = {Point(1e9, 0), Point(0, -1e9), Point(40, -4)};
    far.lines = {LineString{Point(-1e6, 50), Point(1e6, 50)}};
    EXPECT_EQ(blockedBy(lattice, far, 10.0)->blockedCount(), 0);
    Shape through;
    through.lines = {LineString{Point(-1e6, -4.1), Point(1e6, -4.1)}};
    EXPECT_EQ(judge(lattice, through, 0.0), "");
    EXPECT_GE(blockedBy(lattice, through, 0.0)->blockedCount(), 9);
}

TYPED_TEST(OccupancyBuilderOf, outsideOfTheCoverageIsBlocked)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const double pitch = std::pow(10.0, random.real(-2.0, 2.0));
        const TypeParam lattice({pitch * random.real(-9, 9), pitch * random.real(-9, 9)}, pitch, 30, 20);
        // up to three coverages side by side, with or without gaps in them, one perhaps over the border
        std::vector<Polygon> areas;
        for (std::int64_t i = random.integer(0, 3); i > 0; --i)
        {
            const Point centre = lattice.northWest() + pitch * Point(10.0 * static_cast<double>(i) - 4.0, -9.0);
            areas.push_back(randomArea(random, centre, 4.9 * pitch, random.chance(0.5)));
        }
        const double radius = random.chance(0.5) ? 0.0 : pitch * random.real(0.0, 2.0);
        OccupancyBuilder builder(lattice);
        builder.blockOutside(areas, radius);
        const auto occupancy = builder.build();
        const CellOracle<TypeParam> oracle(lattice);
        forEachCell(lattice, 0,
                    [&](typename TypeParam::Cell cell)
                    {
                        bool inside = false;
                        long double edge = std::numeric_limits<long double>::infinity();
                        for (const Polygon &area : areas)
                        {
                            inside = inside || oracle.isCentreInside(area, cell);
                            edge = std::min(edge, oracle.distanceToRings(area, cell));
                        }
                        const bool mustBeBlocked = !inside || edge <= radius;
                        const bool mustBeFree = inside && edge > radius + 1e-9 * 50.0 * pitch;
                        ASSERT_TRUE(!mustBeBlocked || occupancy->isBlocked(cell)) << toPicture(*occupancy);
                        ASSERT_TRUE(!mustBeFree || occupancy->isFree(cell)) << toPicture(*occupancy);
                    });
        forEachCell(lattice, CellLayout::frame,
                    [&](typename TypeParam::Cell cell) {
                        ASSERT_TRUE(lattice.contains(cell) || occupancy->isBlockedAt(occupancy->layout().index(cell)));
                    });
    }
}

TYPED_TEST(OccupancyBuilderOf, shapesAddUp)
{
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice({0.0, 0.0}, 1.0, 30, 20);
        Shape first;
        first.areas.push_back(randomArea(random, around(random, lattice), 6.0, true));
        Shape second;
        second.lines.push_back(LineString{around(random, lattice), around(random, lattice)});
        OccupancyBuilder builder(lattice);
        builder.block(first, 0.0);
        const auto before = builder.build();
        builder.block(second, 0.7);
        const auto both = builder.build();
        const auto one = blockedBy(lattice, first, 0.0);
        const auto other = blockedBy(lattice, second, 0.7);
        EXPECT_EQ(before->words(), one->words()) << "what was built does not change any more";
        OccupancyBuilder onTop(*before);
        onTop.block(second, 0.7);
        EXPECT_EQ(onTop.build()->words(), both->words());
        EXPECT_TRUE(onTop.build()->lattice() == lattice);
        forEachCell(lattice, 0,
                    [&](typename TypeParam::Cell cell)
                    { ASSERT_EQ(both->isBlocked(cell), one->isBlocked(cell) || other->isBlocked(cell)); });
    }
}

TYPED_TEST(OccupancyBuilderOf, refusesWhatIsNoNumber)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    OccupancyBuilder builder(TypeParam(Point(0, 0), 1.0, 4, 4));
    Shape point;
    point.points.push_back(Point(1.0, nan));
    EXPECT_THROW(builder.block(point, 0.0), std::domain_error);
    Shape area;
    area.areas.emplace_back();
    for (const Point &p : {Point(0, 0), Point(2, 0), Point(nan, -2), Point(0, 0)})
        area.areas.back().outer().push_back(p);
    EXPECT_THROW(builder.block(area, 0.0), std::domain_error);
    EXPECT_THROW(builder.blockOutside(area.areas, 0.0), std::domain_error);
}

TYPED_TEST(OccupancyBuilderOf, takesCoordinatesBeyondAllMeasure)
{
    OccupancyBuilder builder(TypeParam(Point(0, 0), 1.0, 4, 4));
    Shape line;
    line.lines.push_back({Point(-1e300, -2.0), Point(1e300, -2.0)});
    line.points.push_back(Point(1e25, -1e25));
    builder.block(line, 0.0);
    EXPECT_GT(builder.build()->blockedCount(), 0);
}
