#include "Drawing.h"

#include "Report.h"
#include "common/Failure.h"

#include <seahex/io/DiveProfile.h>
#include <seahex/io/Picture.h>
#include <seahex/io/SeabedPicture.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace plan_dive
{
namespace
{

using seahex::horizontal;
using seahex::Point;
using seahex::Point3;

constexpr const char *notForNavigation = "not for navigation";

std::string title(const Options &options, const Result &result)
{
    const std::string seabed = std::filesystem::path(result.seabed.source).filename().string();
    return summaryLine(options, result) + "\n" + seabed + ", " + toString(options.from.place) + " to " +
           toString(options.to.place);
}

std::vector<Point3> writtenPoints(const Result &result)
{
    std::vector<Point3> points;
    for (std::size_t i = 0; i < result.written.waypoints.size(); ++i)
    {
        const Point p = result.seabed.projection.forward(writtenPosition(result.written.waypoints[i]));
        points.emplace_back(p.x(), p.y(), result.written.depthsM[i]);
    }
    return points;
}

template <class Draw>
void orFail(const Draw &draw)
{
    try
    {
        draw();
    }
    catch (const seahex::PictureError &error)
    {
        throw demos::Failure(demos::Exit::Usage, error.what());
    }
}

/// The dive, and a quarter of its extent around it.
seahex::Box around(const Result &result)
{
    seahex::Box box{horizontal(result.dive.front()), horizontal(result.dive.front())};
    for (const Point3 &p : result.dive)
    {
        box.min = box.min.cwiseMin(horizontal(p));
        box.max = box.max.cwiseMax(horizontal(p));
    }
    const double margin = 0.25 * (box.max - box.min).maxCoeff() + result.seabed.depths->grid().spacing().maxCoeff();
    return {box.min - Point(margin, margin), box.max + Point(margin, margin)};
}

}  // namespace

void drawProfile(const Options &options, const Result &result)
{
    constexpr double samples = 2000.0;  // of the seabed
    const std::vector<Point3> points = writtenPoints(result);
    seahex::DiveProfileContent content;
    double distanceM = 0.0;
    const auto sample = [&](const Point3 &p, double atM)
    {
        content.seabed.push_back({atM, result.seabed.depths->depthAt(horizontal(p))});
    };
    content.path.push_back({0.0, points.front().z()});
    sample(points.front(), 0.0);
    const double wholeM = std::max(rhumbLengthM(result.written), 1e-3);
    for (std::size_t i = 1; i < points.size(); ++i)
    {
        const double legM = rhumbLeg(result.written.waypoints[i - 1], result.written.waypoints[i]).lengthM;
        const int steps = 1 + static_cast<int>(samples * legM / wholeM);
        for (int k = 1; k <= steps; ++k)
        {
            const double t = static_cast<double>(k) / steps;
            sample(points[i - 1] + t * (points[i] - points[i - 1]), distanceM + t * legM);
        }
        distanceM += legM;
        content.path.push_back({distanceM, points[i].z()});
    }
    content.clearanceM = options.limits.clearanceM;
    content.ceilingM = options.limits.ceilingM;
    content.deepestM = options.limits.deepestM;
    content.title = title(options, result);
    content.footer = notForNavigation;
    orFail([&] { seahex::writeDiveProfile(options.profile, content); });
}

void drawSeabed(const Options &options, const Result &result)
{
    seahex::SeabedPictureContent content;
    content.seabed = result.seabed.depths;
    content.dives = {{result.dive}};
    content.crop = around(result);
    content.title = title(options, result);
    content.footer = notForNavigation;
    orFail([&] { seahex::writeSeabedPicture(options.picture, content); });
}

}  // namespace plan_dive
