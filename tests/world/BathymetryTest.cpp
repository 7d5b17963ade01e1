#include <seahex/world/Bathymetry.h>

#include "support/Random.h"
#include "support/RationalSeabed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <thread>

using namespace seahex;
using namespace seahex::test;

namespace
{

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr double unknown = Bathymetry::unknownDepth;

/// Depths at unit spacing about the origin, the picture's north up.
Bathymetry seabedOf(const std::vector<std::vector<float>> &northUp)
{
    std::vector<float> depths;
    for (auto row = northUp.rbegin(); row != northUp.rend(); ++row)
        depths.insert(depths.end(), row->begin(), row->end());
    return {NodeGrid(Point(0, 0), Point(1, 1), static_cast<std::int64_t>(northUp.front().size()),
                     static_cast<std::int64_t>(northUp.size())),
            depths};
}

/// Depths, place and spacing in binary fractions, so that doubles hold what the rational oracle holds.
Bathymetry anySeabed(Random &random, double unknownShare)
{
    const std::int64_t columns = random.integer(2, 6);
    const std::int64_t rows = random.integer(2, 5);
    std::vector<float> depths;
    for (std::int64_t i = 0; i < columns * rows; ++i)
        depths.push_back(random.chance(unknownShare) ? NaN : static_cast<float>(random.integer(-8, 60)) / 4.0F);
    const Point spacing(std::ldexp(1.0, static_cast<int>(random.integer(-2, 8))),
                        std::ldexp(1.0, static_cast<int>(random.integer(-2, 8))));
    const Point southWest(static_cast<double>(random.integer(-4000, 4000)) / 4.0,
                          static_cast<double>(random.integer(-4000, 4000)) / 4.0);
    return {NodeGrid(southWest, spacing, columns, rows), depths};
}

/// A place of the grid: on a node, a line, a quarter of a step, anywhere, or (seldom) outside.
Point anyPlace(Random &random, const NodeGrid &grid)
{
    const auto along = [&random](std::int64_t count)
    {
        const auto last = static_cast<double>(count - 1);
        switch (random.integer(0, 9))
        {
            case 0:
            case 1:
            case 2:
                return static_cast<double>(random.integer(0, count - 1));
            case 3:
            case 4:
                return static_cast<double>(random.integer(0, 4 * (count - 1))) / 4.0;
            case 5:
                return random.chance(0.1) ? last + 0.25 : 0.0;
            default:
                return std::ldexp(std::floor(std::ldexp(random.real(0.0, last), 20)), -20);
        }
    };
    const double x = along(grid.columns());
    const double y = along(grid.rows());
    return grid.southWest() + grid.spacing().cwiseProduct(Point(x, y));
}

Point3 at(const Point &p, double z)
{
    return {p.x(), p.y(), z};
}

void expectEqual(double value, const std::optional<Rational> &exact, const std::string &what)
{
    if (exact)
        EXPECT_NEAR(value, static_cast<double>(*exact), 1e-12 * 100.0) << what;
    else
        EXPECT_EQ(value, unknown) << what;
}

}  // namespace

TEST(Bathymetry, isBilinearBetweenNodes)
{
    const Bathymetry seabed = seabedOf({{30, 50}, {10, 20}});
    EXPECT_EQ(seabed.depthAt(Point(0, 0)), 10);
    EXPECT_EQ(seabed.depthAt(Point(1, 0)), 20);
    EXPECT_EQ(seabed.depthAt(Point(0, 1)), 30);
    EXPECT_EQ(seabed.depthAt(Point(1, 1)), 50);
    EXPECT_EQ(seabed.depthAt(Point(0.5, 0)), 15);
    EXPECT_EQ(seabed.depthAt(Point(0.5, 0.5)), 27.5);
    EXPECT_EQ(seabed.greatestDepth(), 50);
}

TEST(Bathymetry, leastAlongALineIsTheLowPointOfTheParabola)
{
    // depth = 16 + 16 x y - 8 x - 8 y: along y = x the parabola 16 - 16 x + 16 x^2, least 12 at the middle
    const Bathymetry seabed = seabedOf({{8, 16}, {16, 8}});
    EXPECT_EQ(seabed.leastDepth(Point(0, 0), Point(1, 1)), 12);
    EXPECT_EQ(seabed.leastDepth(Point(0, 1), Point(1, 0)), 8) << "a ridge: least at the ends";
    // a line that climbs by 8 m over the dip is nearest to the seabed at x = 1/4: 16 - 4 + 1 - 0 - (8 - 8 / 4)
    EXPECT_EQ(seabed.leastWaterBelow(Point3(0, 0, 8), Point3(1, 1, 0)), 13 - 6);
}

TEST(Bathymetry, whatIsUnknownIsUnknownUpToTheEdgesOfItsCells)
{
    const Bathymetry seabed = seabedOf({{9, 9, 9, 9, 9}, {9, 9, 9, 9, 9}, {9, 9, 9, NaN, 9}, {9, 9, 9, 9, 9}});
    EXPECT_EQ(seabed.depthAt(Point(1.5, 1.0)), 9);
    EXPECT_EQ(seabed.depthAt(Point(2.0, 1.0)), unknown) << "a known node of an unknown cell";
    EXPECT_EQ(seabed.depthAt(Point(2.5, 2.5)), 9);
    EXPECT_EQ(seabed.depthAt(Point(2.5, 2.0)), unknown) << "the edge of an unknown cell";
    EXPECT_EQ(seabed.leastDepth(Point(0, 2.5), Point(4, 2.5)), 9);
    EXPECT_EQ(seabed.leastDepth(Point(0, 2), Point(4, 2)), unknown) << "along that edge";
    EXPECT_EQ(seabed.leastDepth(Point(1, 3), Point(2, 2)), unknown) << "up to that corner";
    EXPECT_EQ(seabed.leastDepth(Box{Point(0, 0), Point(1.75, 3)}), 9);
    EXPECT_EQ(seabed.leastDepth(Box{Point(0, 0), Point(2, 3)}), unknown);
    EXPECT_EQ(seabed.leastDepth({Point(0, 0), Point(1.75, 1), Point(0, 3)}), 9);
    EXPECT_EQ(seabed.leastDepth({Point(0, 0), Point(4, 0), Point(4, 3), Point(0, 3)}), unknown);
}

TEST(Bathymetry, outsideIsUnknownAndSoIsWhatIsNoNumber)
{
    const Bathymetry seabed = seabedOf({{9, 9, 9}, {9, 9, 9}});
    const double nan = std::nan("");
    EXPECT_EQ(seabed.depthAt(Point(2, 1)), 9) << "the bounds belong to the inside";
    EXPECT_EQ(seabed.depthAt(Point(std::nextafter(2.0, 3.0), 1)), unknown);
    EXPECT_EQ(seabed.depthAt(Point(-1e-12, 1)), unknown);
    EXPECT_EQ(seabed.depthAt(Point(nan, 1)), unknown);
    EXPECT_EQ(seabed.leastDepth(Point(0, 0), Point(2.5, 1)), unknown);
    EXPECT_EQ(seabed.leastDepth(Point(0, 0), Point(1, nan)), unknown);
    EXPECT_EQ(seabed.leastWaterBelow(Point3(0, 0, 1), Point3(1, 1, nan)), unknown);
    EXPECT_EQ(seabed.leastWaterBelow(Point3(0, 0, nan), Point3(1, 1, 1)), unknown);
    EXPECT_EQ(seabed.leastDepth(Box{Point(0, 0), Point(3, 1)}), unknown);
    EXPECT_EQ(seabed.leastDepth(Box{Point(1, 0), Point(0, 1)}), unknown) << "no box";
    EXPECT_EQ(seabed.leastDepth(Box{Point(0, 0), Point(1, nan)}), unknown);
    EXPECT_EQ(seabed.leastDepth(std::vector<Point>()), unknown);
    EXPECT_EQ(seabed.leastDepth({Point(0, 0), Point(3, 0), Point(0, 1)}), unknown);
}

TEST(Bathymetry, everyValueThatIsNoDepthIsUnknown)
{
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float value : {NaN, infinity, -infinity})
    {
        const Bathymetry seabed = seabedOf({{9, 9}, {9, value}});
        EXPECT_EQ(seabed.nodeDepth(1, 0), Bathymetry::unknownDepth);
        EXPECT_EQ(seabed.depthAt(Point(0.5, 0.5)), unknown);
        EXPECT_EQ(seabed.greatestDepth(), 9);
    }
}

TEST(Bathymetry, refusesWhatIsNoGrid)
{
    EXPECT_THROW(Bathymetry(NodeGrid(Point(0, 0), Point(1, 1), 2, 2), {1, 2, 3}), std::length_error);
    EXPECT_THROW(NodeGrid(Point(0, 0), Point(1, 1), 1, 2), std::domain_error);
    EXPECT_THROW(NodeGrid(Point(0, 0), Point(1, 1), 2, 0), std::domain_error);
    EXPECT_THROW(NodeGrid(Point(0, 0), Point(1, 1), INT64_C(1) << 40, 2), std::domain_error);
    EXPECT_THROW(NodeGrid(Point(0, 0), Point(0, 1), 2, 2), std::domain_error);
    EXPECT_THROW(NodeGrid(Point(0, 0), Point(1, -1), 2, 2), std::domain_error);
    EXPECT_THROW(NodeGrid(Point(0, 0), Point(std::nan(""), 1), 2, 2), std::domain_error);
    EXPECT_THROW(NodeGrid(Point(0, INFINITY), Point(1, 1), 2, 2), std::domain_error);
    EXPECT_THROW(NodeGrid(Point(1e18, 0), Point(1, 1), 2, 2), std::domain_error) << "all nodes at one place";
}

// Every two by two grid of the depths 0, 1, 2, and every pair of places on a net of half steps, in rational
// arithmetic.
TEST(Bathymetry, smallGridsEqualRationalArithmeticExhaustively)
{
    for (int pattern = 0; pattern < 81; ++pattern)
    {
        const auto digit = [pattern](int power)
        {
            return static_cast<float>(pattern / power % 3);
        };
        const Bathymetry seabed = seabedOf({{digit(1), digit(3)}, {digit(9), digit(27)}});
        const RationalSeabed oracle(seabed);
        for (int places = 0; places < 9 * 9; ++places)
        {
            const Point a(0.5 * (places % 3), 0.5 * (places / 3 % 3));
            const Point b(0.5 * (places / 9 % 3), 0.5 * (places / 27));
            for (const double z : {0.0, 0.25, 2.0})
                ASSERT_NEAR(seabed.leastWaterBelow(at(a, 0.0), at(b, z)),
                            static_cast<double>(*oracle.leastWaterBelow(at(a, 0.0), at(b, z))), 1e-14)
                    << "pattern " << pattern << ": " << a.transpose() << " to " << b.transpose() << ", z " << z;
        }
    }
}

TEST(Bathymetry, segmentsEqualRationalArithmetic)
{
    int known = 0;
    int unknowns = 0;
    forEachSeed(400,
                [&](Random &random)
                {
                    const Bathymetry seabed = anySeabed(random, random.chance(0.5) ? 0.0 : 0.15);
                    const RationalSeabed oracle(seabed);
                    for (int i = 0; i < 10; ++i)
                    {
                        const Point3 a = at(anyPlace(random, seabed.grid()), 0.25 * double(random.integer(0, 40)));
                        const Point3 b =
                            i == 0 ? a : at(anyPlace(random, seabed.grid()), 0.25 * double(random.integer(0, 40)));
                        const double least = seabed.leastWaterBelow(a, b);
                        const auto exact = oracle.leastWaterBelow(a, b);
                        (exact ? known : unknowns) += 1;
                        expectEqual(least, exact, "segment");
                        EXPECT_EQ(seabed.leastWaterBelow(b, a), least) << "backwards, bit for bit";
                        EXPECT_LE(least, seabed.depthAt(horizontal(a)) - a.z());
                        EXPECT_LE(least, seabed.depthAt(horizontal(b)) - b.z());
                        expectEqual(seabed.leastDepth(horizontal(a), horizontal(b)),
                                    oracle.leastWaterBelow(at(horizontal(a), 0), at(horizontal(b), 0)), "depth");
                        const double enough = random.real(-10.0, 10.0);
                        const double hasty = seabed.leastWaterBelow(a, b, enough);
                        EXPECT_GE(hasty, least);
                        EXPECT_EQ(hasty < enough, least < enough);
                    }
                });
    EXPECT_GT(known, 1000);
    EXPECT_GT(unknowns, 500);
}

TEST(Bathymetry, boxesEqualRationalArithmetic)
{
    int known = 0;
    int unknowns = 0;
    forEachSeed(400,
                [&](Random &random)
                {
                    const Bathymetry seabed = anySeabed(random, random.chance(0.5) ? 0.0 : 0.1);
                    const RationalSeabed oracle(seabed);
                    for (int i = 0; i < 5; ++i)
                    {
                        const Point a = anyPlace(random, seabed.grid());
                        const Point b = i == 0 ? a : anyPlace(random, seabed.grid());
                        const Box box{a.cwiseMin(b), a.cwiseMax(b)};
                        const auto exact = oracle.leastDepth(box);
                        (exact ? known : unknowns) += 1;
                        expectEqual(seabed.leastDepth(box), exact, "box");
                        const std::vector<Point> corners = {box.min, Point(box.max.x(), box.min.y()), box.max,
                                                            Point(box.min.x(), box.max.y())};
                        expectEqual(seabed.leastDepth(corners), exact, "the same as a polygon");
                    }
                });
    EXPECT_GT(known, 500);
    EXPECT_GT(unknowns, 200);
}

// Dense samples are never lower than the least, and some come near to it; where one is unknown, so is the least.
TEST(Bathymetry, hexagonsAndTrianglesEqualDenseSampling)
{
    int known = 0;
    forEachSeed(
        60,
        [&](Random &random)
        {
            const Bathymetry seabed = anySeabed(random, random.chance(0.6) ? 0.0 : 0.05);
            const NodeGrid &grid = seabed.grid();
            const Point extent = grid.bounds().max - grid.bounds().min;
            const HexLattice lattice(Point(grid.bounds().min.x(), grid.bounds().max.y()),
                                     extent.minCoeff() * random.real(0.1, 0.6), 4, 4);
            const auto cell = toOffset(lattice.cellAt(anyPlace(random, grid)));
            const std::vector<Point> corners =
                random.chance(0.5)
                    ? Lattice(lattice).corners(cell)
                    : std::vector<Point>{anyPlace(random, grid), anyPlace(random, grid), anyPlace(random, grid)};
            const double least = seabed.leastDepth(corners);
            double lowest = std::numeric_limits<double>::infinity();
            constexpr int steps = 60;
            for (std::size_t k = 2; k < corners.size(); ++k)
                for (int i = 0; i <= steps; ++i)
                    for (int j = 0; i + j <= steps; ++j)
                    {
                        const Point p = corners[0] + (corners[k - 1] - corners[0]) * i / double(steps) +
                                        (corners[k] - corners[0]) * j / double(steps);
                        if (grid.bounds().contains(p))
                            lowest = std::min(lowest, seabed.depthAt(p));
                        else if ((p - grid.node(0, 0)).minCoeff() < -1e-6 || (grid.bounds().max - p).minCoeff() < -1e-6)
                            lowest = unknown;
                    }
            if (lowest == unknown)
            {
                EXPECT_EQ(least, unknown);
            }
            if (least == unknown)
                return;  // by a corner or an edge that the samples miss
            ++known;
            EXPECT_GE(lowest, least - 1e-9);
            // 60 samples over at most 5 cells with 17 m between neighbours
            EXPECT_LE(lowest, least + 2.0 * 17.0 * 5.0 / steps);
        });
    EXPECT_GT(known, 20);
}

// Not binary fractions: any place and spacing, against long double samples along the segment.
TEST(Bathymetry, longSegmentsOnLargeGridsEqualDenseSampling)
{
    forEachSeed(40,
                [&](Random &random)
                {
                    const NodeGrid grid(random.pointIn({Point(-1e6, -1e6), Point(1e6, 1e6)}),
                                        Point(random.real(0.5, 900.0), random.real(0.5, 900.0)), 300, 200);
                    std::vector<float> depths;
                    for (std::int64_t i = 0; i < grid.nodeCount(); ++i)
                        depths.push_back(static_cast<float>(random.real(0.0, 50.0)));
                    const Bathymetry seabed(grid, depths);
                    const Point3 a = at(random.pointIn(grid.bounds()), random.real(0.0, 50.0));
                    const Point3 b = at(random.pointIn(grid.bounds()), random.real(0.0, 50.0));
                    const double least = seabed.leastWaterBelow(a, b);
                    double lowest = std::numeric_limits<double>::infinity();
                    constexpr int samples = 40000;
                    for (int i = 0; i <= samples; ++i)
                    {
                        const Point3 p = a + (b - a) * i / double(samples);
                        lowest = std::min(lowest, seabed.depthAt(horizontal(p)) - p.z());
                    }
                    EXPECT_GE(lowest, least - 1e-6);
                    // at most 500 cells over 40,000 samples, at most 200 m a cell
                    EXPECT_LE(lowest, least + 200.0 * 500.0 / samples);
                });
}

TEST(Bathymetry, manyThreadsReadTheSame)
{
    Random random(7);
    std::vector<float> depths;
    for (int i = 0; i < 10000; ++i)
        depths.push_back(static_cast<float>(random.real(0.0, 50.0)));
    const Bathymetry seabed(NodeGrid(Point(0, 0), Point(1, 1), 100, 100), depths);
    std::vector<std::pair<Point3, Point3>> segments;
    std::vector<double> alone;
    for (int i = 0; i < 1000; ++i)
    {
        segments.emplace_back(at(random.pointIn(seabed.grid().bounds()), 3),
                              at(random.pointIn(seabed.grid().bounds()), 5));
        alone.push_back(seabed.leastWaterBelow(segments.back().first, segments.back().second));
    }
    std::vector<std::vector<double>> together(4, std::vector<double>(segments.size()));
    std::vector<std::thread> threads;
    for (auto &answers : together)
        threads.emplace_back(
            [&]
            {
                for (std::size_t i = 0; i < segments.size(); ++i)
                    answers[i] = seabed.leastWaterBelow(segments[i].first, segments[i].second);
            });
    for (std::thread &thread : threads)
        thread.join();
    for (const auto &answers : together)
        EXPECT_EQ(answers, alone);
}

TEST(Bathymetry, holdsFourBytesANode)
{
    const Bathymetry seabed(NodeGrid(Point(0, 0), Point(1, 1), 1000, 500), std::vector<float>(500000, 1.0F));
    EXPECT_LT(seabed.byteCount(), 4 * 500000 + 1000);
}
