#include "seahex/io/PictureFrame.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace seahex
{

namespace
{

std::shared_ptr<const Occupancy> allBlocked(const Lattice &lattice)
{
    const CellLayout layout(lattice.columns(), lattice.rows());
    return std::make_shared<const Occupancy>(lattice, layout,
                                             std::vector<std::uint64_t>(layout.wordCount(), ~std::uint64_t{0}));
}

const Projection &metricFrame()
{
    static const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(60.0, 5.0));
    return projection;
}

}  // namespace

TEST(PictureFrame, ShowsTheBoundsOfTheLatticeWithNorthUp)
{
    const HexLattice lattice({1000.0, 2000.0}, 10.0, 90, 70);
    const PictureFrame frame = pictureFrame({metricFrame(), allBlocked(lattice)});
    const Box bounds = lattice.bounds();
    EXPECT_LT((frame.toPage({bounds.min.x(), bounds.max.y()}) - frame.map.min).norm(), 1.0);
    EXPECT_LT((frame.toPage({bounds.max.x(), bounds.min.y()}) - frame.map.max).norm(), 1.0);
    EXPECT_DOUBLE_EQ(frame.pxPerUnitX, frame.pxPerUnitY);
    EXPECT_EQ(frame.widthPx, 1600);
}

TEST(PictureFrame, SqueezesDegreesOfLongitudeByTheLatitude)
{
    const HexLattice north({4.0, 60.5}, 0.01, 100, 100);
    const PictureFrame frame = pictureFrame({Projection::plateCarree(), allBlocked(north)});
    // A degree at 60.06 N: 55.7 km to the east, 111.4 km to the north.
    const double latitude = 0.5 * (frame.plane.min.y() + frame.plane.max.y());
    EXPECT_NEAR(frame.pxPerUnitX / frame.pxPerUnitY, std::cos(latitude * M_PI / 180.0), 0.002);
    EXPECT_NEAR(frame.pxPerUnitY * frame.metresPerPx, 111400.0, 30.0);
}

RC_GTEST_PROP(PictureFrame, KeepsEveryViewWithinThePageAndSanelyShaped, ())
{
    const double width = std::pow(10.0, *rc::gen::inRange(-1, 6));
    const double height = std::pow(10.0, *rc::gen::inRange(-1, 6));
    const HexLattice lattice({0.0, 0.0}, 10.0, 5, 5);
    PictureContent content{metricFrame(), allBlocked(lattice)};
    content.crop = Box{{0.0, 0.0}, {width, height}};
    content.widthPx = *rc::gen::inRange(400, 3000);
    content.title = *rc::gen::element<std::string>("", "one line", "two\nlines");
    const PictureFrame frame = pictureFrame(content);

    RC_ASSERT(frame.map.min.minCoeff() > 0.0);
    RC_ASSERT(frame.map.max.x() < frame.widthPx);
    RC_ASSERT(frame.map.max.y() < frame.legendTop);
    RC_ASSERT(frame.legendTop < frame.heightPx);
    const Point size = frame.map.max - frame.map.min;
    RC_ASSERT(size.maxCoeff() <= 8.1 * size.minCoeff());
    RC_ASSERT(frame.heightPx <= 1.5 * frame.widthPx);
    // The crop box is inside the map, and page and plane are each other's inverse.
    const Point corner = frame.toPage({width, 0.0});
    RC_ASSERT(corner.x() <= frame.map.max.x() + 1e-6);
    RC_ASSERT(corner.y() <= frame.map.max.y() + 1e-6);
    RC_ASSERT((frame.toPlane(corner) - Point(width, 0.0)).norm() <= 1e-9 * (width + height));
}

}  // namespace seahex
