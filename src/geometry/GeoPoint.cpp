#include "seahex/geometry/GeoPoint.h"

#include <cmath>
#include <cstdio>

namespace seahex
{

GeoPoint GeoPoint::fromLatLon(double latitudeDeg, double longitudeDeg)
{
    if (!std::isfinite(latitudeDeg) || !std::isfinite(longitudeDeg))
        throw PositionError("position is not a number: latitude " + std::to_string(latitudeDeg) + ", longitude " +
                            std::to_string(longitudeDeg) + " degrees");
    if (std::abs(latitudeDeg) > 90.0)
        throw PositionError("latitude " + std::to_string(latitudeDeg) + " degrees lies beyond a pole");
    return GeoPoint(latitudeDeg, longitudeDeg);
}

GeoPoint GeoPoint::fromLonLat(double longitudeDeg, double latitudeDeg)
{
    return fromLatLon(latitudeDeg, longitudeDeg);
}

std::string toString(const GeoPoint &position)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.6f %c %.6f %c", std::abs(position.latitudeDeg()),
                  position.latitudeDeg() < 0 ? 'S' : 'N', std::abs(position.longitudeDeg()),
                  position.longitudeDeg() < 0 ? 'W' : 'E');
    return text;
}

}  // namespace seahex
