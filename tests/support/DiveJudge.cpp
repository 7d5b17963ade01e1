#include "support/DiveJudge.h"

#include <cmath>
#include <sstream>

namespace seahex::test
{

DiveJudge::DiveJudge(const std::filesystem::path &raster) : raster_(raster)
{
    const auto &t = raster_.transform;
    middle_ = Point(t[0] + 0.5 * raster_.columns * t[1], t[3] + 0.5 * raster_.rows * t[5]);
    const long double pi = 3.141592653589793238462643383279502884L;
    const long double axis = 6378137.0L;
    const long double minorAxis = axis - axis / 298.257223563L;
    const long double latitude = static_cast<long double>(middle_.y()) * pi / 180.0L;
    // Radii of curvature by the axes: a^2 / w and (a b)^2 / w^3 with w the root of (a cos)^2 + (b sin)^2.
    const long double w = std::hypot(axis * std::cos(latitude), minorAxis * std::sin(latitude));
    metresPerDegree_ = Point(static_cast<double>(axis * axis / w * std::cos(latitude) * pi / 180.0L),
                             static_cast<double>(axis * axis * minorAxis * minorAxis / (w * w * w) * pi / 180.0L));
}

double DiveJudge::waterBelow(const Point3 &p) const
{
    const double longitude = middle_.x() + p.x() / metresPerDegree_.x();
    const double latitude = middle_.y() + p.y() / metresPerDegree_.y();
    return -raster_.bilinear(longitude, latitude) - p.z();
}

std::string DiveJudge::fault(const std::vector<Point3> &dive, double clearanceM, double ceilingM) const
{
    std::ostringstream fault;
    const Point cell(std::abs(raster_.transform[1]) * metresPerDegree_.x(),
                     std::abs(raster_.transform[5]) * metresPerDegree_.y());
    for (std::size_t leg = 0; leg + 1 < dive.size(); ++leg)
    {
        const Point3 by = dive[leg + 1] - dive[leg];
        const double cells = std::abs(by.x()) / cell.x() + std::abs(by.y()) / cell.y();
        const int samples = 1 + static_cast<int>(std::ceil(10.0 * cells));
        for (int i = 0; i <= samples; ++i)
        {
            const Point3 p = dive[leg] + by * (static_cast<double>(i) / samples);
            const double water = waterBelow(p);
            if (!(water >= clearanceM) || !(p.z() >= ceilingM))
            {
                fault << "leg " << leg << " at " << p.transpose() << " has " << water << " m of water below";
                return fault.str();
            }
        }
    }
    return "";
}

}  // namespace seahex::test
