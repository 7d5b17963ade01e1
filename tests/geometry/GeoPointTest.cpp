#include <seahex/geometry/GeoPoint.h>

#include <limits>

#include <gtest/gtest.h>

using namespace seahex;

TEST(GeoPoint, makersNameTheOrder)
{
    const GeoPoint position = GeoPoint::fromLatLon(21.635, 112.521);
    EXPECT_EQ(position.latitudeDeg(), 21.635);
    EXPECT_EQ(position.longitudeDeg(), 112.521);
    EXPECT_EQ(position, GeoPoint::fromLonLat(112.521, 21.635));
    EXPECT_NE(position, GeoPoint::fromLatLon(21.635, 112.522));
    EXPECT_NE(position, GeoPoint::fromLatLon(21.636, 112.521));
}

TEST(GeoPoint, refusesWhatIsNoPosition)
{
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(GeoPoint::fromLatLon(notANumber, 0.0), PositionError);
    EXPECT_THROW(GeoPoint::fromLatLon(0.0, notANumber), PositionError);
    EXPECT_THROW(GeoPoint::fromLatLon(0.0, infinity), PositionError);
    EXPECT_THROW(GeoPoint::fromLatLon(90.0001, 0.0), PositionError);
    EXPECT_THROW(GeoPoint::fromLatLon(-112.5, 21.6), PositionError);
    EXPECT_THROW(GeoPoint::fromLonLat(21.6, 112.5), PositionError) << "swapped";
    EXPECT_NO_THROW(GeoPoint::fromLatLon(90.0, 180.0));
    EXPECT_NO_THROW(GeoPoint::fromLatLon(-90.0, 359.0));
}

TEST(GeoPoint, textNamesHemispheres)
{
    EXPECT_EQ(toString(GeoPoint::fromLatLon(21.635, 112.521)), "21.635000 N 112.521000 E");
    EXPECT_EQ(toString(GeoPoint::fromLatLon(-0.5, -70.25)), "0.500000 S 70.250000 W");
}
