#pragma once

#include "support/TestRasters.h"

#include <seahex/geometry/Point3.h>

#include <filesystem>
#include <string>
#include <vector>

namespace seahex::test
{

/// Judges dives against a raster of heights in degrees, read through GDAL: the bilinear surface sampled at a tenth of a
/// cell along every leg. Shares nothing with the library's reader, surface or frame but their definition.
class DiveJudge
{
public:
    explicit DiveJudge(const std::filesystem::path &raster);

    /// The first fault of a dive, positions in metres about the middle of the raster's nodes; empty for a sound one.
    std::string fault(const std::vector<Point3> &dive, double clearanceM, double ceilingM) const;

    /// The water below a position, not a number where there is no raster or no data.
    double waterBelow(const Point3 &p) const;

private:
    PlainRaster raster_;
    Point middle_;           // longitude, latitude
    Point metresPerDegree_;  // there
};

}  // namespace seahex::test
