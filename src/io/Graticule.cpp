#include "seahex/io/Graticule.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace seahex
{

namespace
{

// Steps in units of a ten-thousandth of a minute (about 0.2 m of latitude), so that they are whole numbers.
constexpr double fine = 10000.0 * 60.0;  // units for one degree
constexpr long minute = 10000;
constexpr long degree = 60 * minute;

const std::vector<long> &customarySteps()
{
    static const std::vector<long> steps = []
    {
        std::vector<long> all;
        for (long decade = 1; decade <= minute; decade *= 10)
            for (const long digit : {1L, 2L, 5L})
                all.push_back(digit * decade);
        for (const long more : {10 * minute, 15 * minute, 20 * minute, 30 * minute, degree, 2 * degree, 5 * degree,
                                10 * degree, 15 * degree, 30 * degree})
            all.push_back(more);
        return all;
    }();
    return steps;
}

struct Range
{
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();

    void add(double value)
    {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

// Lines reach a little beyond the extent, so that they surely cross the border of the box.
GraticuleExtent widened(const GraticuleExtent &extent)
{
    const double east = 0.01 * (extent.eastDeg - extent.westDeg);
    const double north = 0.01 * (extent.northDeg - extent.southDeg);
    return {extent.westDeg - east, std::max(extent.southDeg - north, -90.0), extent.eastDeg + east,
            std::min(extent.northDeg + north, 90.0)};
}

// Calls make(number, degrees) for the multiples of the step within the range.
template <class Make>
std::vector<GraticuleLine> multiples(double fromDeg, double toDeg, double stepDeg, Make &&make)
{
    std::vector<GraticuleLine> lines;
    const long last = std::lround(std::floor(toDeg / stepDeg + 1e-9));
    for (long n = std::lround(std::ceil(fromDeg / stepDeg - 1e-9)); n <= last; ++n)
    {
        try
        {
            lines.push_back({n, static_cast<double>(n) * stepDeg, make(static_cast<double>(n) * stepDeg)});
        }
        catch (const PositionError &)
        {
            // A line that the projection can't show, as beyond a pole, is no line of this picture.
        }
    }
    return lines;
}

std::string label(double degrees, double stepDeg, const char *positive, const char *negative)
{
    const long step = std::lround(stepDeg * fine);
    const long value = std::lround(std::abs(degrees) * fine);
    std::string text = std::to_string(value / degree) + "\u00b0";
    if (step % degree != 0)
    {
        int decimals = 0;
        for (long whole = minute; step % whole != 0; whole /= 10)
            ++decimals;
        char minutes[32];
        std::snprintf(minutes, sizeof minutes, "%02ld", value % degree / minute);
        text += minutes;
        if (decimals > 0)
        {
            std::snprintf(minutes, sizeof minutes, "%04ld", value % minute);
            text += "." + std::string(minutes).substr(0, static_cast<std::size_t>(decimals));
        }
        text += "\u2032";
    }
    return value == 0 ? text : text + (degrees < 0 ? negative : positive);
}

}  // namespace

GraticuleExtent graticuleExtent(const Projection &projection, const Box &box)
{
    constexpr int samples = 32;
    Range longitude;
    Range latitude;
    const Point middle = 0.5 * (box.min + box.max);
    double reference = std::numeric_limits<double>::quiet_NaN();
    const auto visit = [&](double x, double y)
    {
        try
        {
            const GeoPoint at = projection.inverse({x, y});
            if (std::isnan(reference))
                reference = at.longitudeDeg();
            const double turns = std::round((reference - at.longitudeDeg()) / 360.0);
            longitude.add(projection.isMetric() ? at.longitudeDeg() + 360.0 * turns : at.longitudeDeg());
            latitude.add(at.latitudeDeg());
        }
        catch (const PositionError &)
        {
            // Corners of a box may lie beyond a pole.
        }
    };
    visit(middle.x(), middle.y());
    for (int i = 0; i <= samples; ++i)
    {
        const Point along = box.min + (box.max - box.min) * (static_cast<double>(i) / samples);
        visit(along.x(), box.min.y());
        visit(along.x(), box.max.y());
        visit(box.min.x(), along.y());
        visit(box.max.x(), along.y());
    }
    if (std::isnan(reference))
        return {};
    return {longitude.least, latitude.least, longitude.most, latitude.most};
}

double graticuleStepDeg(double spanDeg, double maxLines)
{
    for (const long step : customarySteps())
        if (spanDeg * fine <= static_cast<double>(step) * maxLines)
            return static_cast<double>(step) / fine;
    return 30.0;
}

double graticuleTickDeg(double stepDeg)
{
    const long step = std::lround(stepDeg * fine);
    for (const long parts : {5L, 3L, 4L, 2L})
        for (const long tick : customarySteps())
            if (tick * parts == step)
                return static_cast<double>(tick) / fine;
    return stepDeg;
}

std::vector<GraticuleLine> meridians(const Projection &projection, const GraticuleExtent &extent, double stepDeg,
                                     double toleranceM)
{
    const GraticuleExtent reach = widened(extent);
    return multiples(extent.westDeg, extent.eastDeg, stepDeg,
                     [&](double longitude)
                     {
                         return projection.forward({GeoPoint::fromLatLon(reach.southDeg, longitude),
                                                    GeoPoint::fromLatLon(reach.northDeg, longitude)},
                                                   toleranceM);
                     });
}

std::vector<GraticuleLine> parallels(const Projection &projection, const GraticuleExtent &extent, double stepDeg,
                                     double toleranceM)
{
    const GraticuleExtent reach = widened(extent);
    return multiples(extent.southDeg, extent.northDeg, stepDeg,
                     [&](double latitude)
                     {
                         return projection.forward({GeoPoint::fromLatLon(latitude, reach.westDeg),
                                                    GeoPoint::fromLatLon(latitude, reach.eastDeg)},
                                                   toleranceM);
                     });
}

std::string latitudeLabel(double degrees, double stepDeg)
{
    return label(degrees, stepDeg, "N", "S");
}

std::string longitudeLabel(double degrees, double stepDeg)
{
    double longitude = degrees - 360.0 * std::round(degrees / 360.0);
    if (longitude <= -180.0)
        longitude += 360.0;
    return label(longitude, stepDeg, "E", "W");
}

}  // namespace seahex
