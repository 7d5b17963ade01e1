#include "seahex/io/ScaleBar.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace seahex
{

namespace
{

constexpr double equatorM = 6378137.0;              // WGS-84 semi-major axis
constexpr double eccentricity2 = 0.00669437999014;  // WGS-84 first eccentricity, squared
constexpr double nauticalMileM = 1852.0;
constexpr double degree = 0.017453292519943295;

ScaleBar longestBar(double available, double unitM, const std::string &unit)
{
    const double decade = std::pow(10.0, std::floor(std::log10(available)));
    const double lead = available / decade;  // 1 to 10, but for rounding
    const double digit = lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0;
    const double length = digit * decade;
    return {length * unitM, length, digit == 2.0 ? 4 : 5, unit};
}

double flattened(double latitudeDeg)
{
    const double sine = std::sin(latitudeDeg * degree);
    return 1.0 - eccentricity2 * sine * sine;
}

}  // namespace

ScaleBar metricScaleBar(double availableM)
{
    return availableM < 1000.0 ? longestBar(availableM, 1.0, "m") : longestBar(availableM / 1000.0, 1000.0, "km");
}

ScaleBar nauticalScaleBar(double availableM)
{
    return longestBar(availableM / nauticalMileM, nauticalMileM, "NM");
}

double metresPerDegreeOfLongitude(double latitudeDeg)
{
    // Radius of curvature in the prime vertical times the cosine of the latitude.
    return degree * equatorM * std::cos(latitudeDeg * degree) / std::sqrt(flattened(latitudeDeg));
}

double metresPerDegreeOfLatitude(double latitudeDeg)
{
    // Radius of curvature in the meridian.
    return degree * equatorM * (1.0 - eccentricity2) / std::pow(flattened(latitudeDeg), 1.5);
}

std::string plainNumber(double value, int decimals)
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::fixed << std::setprecision(decimals) << value;
    std::string text = out.str();
    if (text.find('.') != std::string::npos)
    {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.')
            text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

}  // namespace seahex
