#pragma once

#include <stdexcept>
#include <string>

namespace seahex
{

/// Thrown when a position is not one: not a number, or a latitude beyond a pole.
class PositionError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// A position on the earth in degrees, WGS-84, as read at the border of the program.
///
/// The makers name the order of their arguments, so that latitude and longitude can't be swapped unseen.
class GeoPoint
{
public:
    /// @throws PositionError if a value is not finite or |latitude| > 90.
    static GeoPoint fromLatLon(double latitudeDeg, double longitudeDeg);

    /// @throws PositionError if a value is not finite or |latitude| > 90.
    static GeoPoint fromLonLat(double longitudeDeg, double latitudeDeg);

    double latitudeDeg() const { return latitudeDeg_; }
    double longitudeDeg() const { return longitudeDeg_; }

    friend bool operator==(const GeoPoint &a, const GeoPoint &b)
    {
        return a.latitudeDeg_ == b.latitudeDeg_ && a.longitudeDeg_ == b.longitudeDeg_;
    }
    friend bool operator!=(const GeoPoint &a, const GeoPoint &b) { return !(a == b); }

private:
    GeoPoint(double latitudeDeg, double longitudeDeg) : latitudeDeg_(latitudeDeg), longitudeDeg_(longitudeDeg) {}

    double latitudeDeg_;
    double longitudeDeg_;
};

/// "21.635000 N 112.521000 E", with six decimals (about 0.1 m).
std::string toString(const GeoPoint &position);

}  // namespace seahex
