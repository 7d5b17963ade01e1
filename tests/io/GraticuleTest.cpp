#include "seahex/io/Graticule.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace seahex
{

TEST(Graticule, LabelsAreDegreesAndMinutesAsFineAsTheStep)
{
    EXPECT_EQ(latitudeLabel(21.5, 0.5), "21°30′N");
    EXPECT_EQ(latitudeLabel(-21.0, 1.0), "21°S");
    EXPECT_EQ(latitudeLabel(-21.0, 0.5), "21°00′S");
    EXPECT_EQ(latitudeLabel(0.0, 5.0), "0°");
    EXPECT_EQ(longitudeLabel(112.0 + 38.5 / 60.0, 0.5 / 60.0), "112°38.5′E");
    EXPECT_EQ(longitudeLabel(-5.0 - 0.01 / 60.0, 0.01 / 60.0), "5°00.01′W");
    EXPECT_EQ(longitudeLabel(190.0, 10.0), "170°W");
    EXPECT_EQ(longitudeLabel(180.0, 10.0), "180°E");
    EXPECT_EQ(longitudeLabel(2.0 - 1e-12, 0.05 / 60.0), "2°00.00′E") << "rounding carries into the degrees";
}

RC_GTEST_PROP(Graticule, StepIsTheSmallestCustomaryOneThatFits, ())
{
    const double span = std::pow(10.0, 0.01 * *rc::gen::inRange(-300, 230));
    const double most = *rc::gen::inRange(2, 12);
    const double step = graticuleStepDeg(span, most);
    const double tick = graticuleTickDeg(step);
    if (step < 30.0)
        RC_ASSERT(span / step <= most * (1.0 + 1e-9));
    // The customary steps lie a factor of 2.5 apart at most, so one that much finer would have been too many lines.
    if (step > 1.01e-4 / 60.0)
        RC_ASSERT(span / (step / 2.51) > most);
    const double parts = step / tick;
    RC_ASSERT(std::abs(parts - std::round(parts)) < 1e-6);
    RC_ASSERT(parts < 5.5);
}

TEST(Graticule, ParallelsBendInAMetricFrameAndStayOnTheirLatitude)
{
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(60.0, 5.0));
    const Box box{{-100000.0, -50000.0}, {100000.0, 50000.0}};
    const GraticuleExtent extent = graticuleExtent(projection, box);
    EXPECT_LT(extent.westDeg, 3.3);
    EXPECT_GT(extent.eastDeg, 6.7);
    const auto lines = parallels(projection, extent, 0.25, 20.0);
    ASSERT_EQ(lines.size(), 3u);  // 59.75, 60 and 60.25 N
    for (const GraticuleLine &line : lines)
    {
        ASSERT_GT(line.line.size(), 4u);
        EXPECT_LE(line.line.front().x(), box.min.x());
        EXPECT_GE(line.line.back().x(), box.max.x());
        for (std::size_t i = 1; i < line.line.size(); ++i)
        {
            const Point middle = 0.5 * (line.line[i - 1] + line.line[i]);
            EXPECT_NEAR(projection.inverse(middle).latitudeDeg(), line.degrees, 25.0 / 111000.0);
        }
    }
}

TEST(Graticule, LongitudesRunOnAcrossTheAntimeridian)
{
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(0.0, 179.9));
    const GraticuleExtent extent = graticuleExtent(projection, {{-40000.0, -10000.0}, {40000.0, 10000.0}});
    EXPECT_NEAR(extent.eastDeg - extent.westDeg, 80000.0 / 111320.0, 0.01);
    const auto lines = meridians(projection, extent, 0.25, 10.0);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(longitudeLabel(lines.back().degrees, 0.25), "179°45′W");
}

TEST(Graticule, LinesInThePlateCarreeFrameCrossTheBoxFromEndToEnd)
{
    const Projection projection = Projection::plateCarree();
    const Box box{{112.45, 21.5}, {113.1, 22.05}};
    const GraticuleExtent extent = graticuleExtent(projection, box);
    EXPECT_DOUBLE_EQ(extent.westDeg, 112.45);
    EXPECT_DOUBLE_EQ(extent.northDeg, 22.05);
    const auto lines = meridians(projection, extent, 0.25, 1.0);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_DOUBLE_EQ(lines.front().degrees, 112.5);
    EXPECT_LT(lines.front().line.front().y(), box.min.y());
    EXPECT_GT(lines.front().line.back().y(), box.max.y());
    EXPECT_EQ(lines[1].number, lines[0].number + 1);
}

TEST(Graticule, ABoxBeyondThePoleStillHasItsLinesOnEarth)
{
    const Projection projection = Projection::plateCarree();
    const GraticuleExtent extent = graticuleExtent(projection, {{0.0, 80.0}, {40.0, 95.0}});
    EXPECT_LE(extent.northDeg, 90.0);
    EXPECT_FALSE(parallels(projection, extent, 2.0, 1.0).empty());
    EXPECT_FALSE(meridians(projection, extent, 10.0, 1.0).empty());
}

}  // namespace seahex
