#pragma once

#include <string>

namespace seahex
{

/// A scale bar: a round length in some unit, parted evenly.
struct ScaleBar
{
    double lengthM = 0.0;  ///< of the whole bar on the ground, metres
    double length = 0.0;   ///< the same in `unit`: 1, 2 or 5 times a power of ten
    int parts = 1;         ///< 4 or 5 equal parts
    std::string unit;      ///< "m", "km" or "NM"
};

/// The longest bar in metres or (from 1 km on) kilometres of at most `availableM` > 0.
ScaleBar metricScaleBar(double availableM);

/// The longest bar in international nautical miles (1852 m) of at most `availableM` > 0.
ScaleBar nauticalScaleBar(double availableM);

/// Metres for one degree of longitude, along the parallel of WGS-84.
double metresPerDegreeOfLongitude(double latitudeDeg);

/// Metres for one degree of latitude, along the meridian of WGS-84.
double metresPerDegreeOfLatitude(double latitudeDeg);

/// A number as people write it: at most `decimals` of them, no trailing zeros, whatever the locale.
std::string plainNumber(double value, int decimals);

}  // namespace seahex
