#include "Drawing.h"

#include "Report.h"
#include "common/Failure.h"

#include <seahex/io/Picture.h>

namespace plan_route
{
namespace
{

void sortHazards(const seahex::ChartArena &arena, seahex::PictureContent &content)
{
    for (std::size_t i = 0; i < arena.hazards().size(); ++i)
    {
        const seahex::Hazard &hazard = arena.hazards()[i];
        const std::string &type = hazard.object->objectClass;
        if (type == "LNDARE")
            content.land.push_back(&hazard.shape);
        else if (arena.verdicts()[i].blocks())
            (hazard.object->rule == seahex::HazardRule::DepthArea ? content.shoals : content.dangers)
                .push_back(&hazard.shape);
    }
}

seahex::LineString lineOf(const seahex::Route &route)
{
    return seahex::LineString(route.waypoints().begin(), route.waypoints().end());
}

std::string chartNames(const seahex::Chart &chart)
{
    std::string names;
    for (const seahex::CellReport &cell : chart.cells)
        names += (names.empty() ? "" : ", ") + cell.name;
    return names;
}

}  // namespace

void drawPicture(const Options &options, const Result &result)
{
    seahex::PictureContent content{result.arena->projection(), result.arena->occupancy()};
    sortHazards(*result.arena, content);
    content.expanded = result.trace;
    content.rawPath = lineOf(result.raw.plane);
    if (result.smoothed)
        content.route = lineOf(result.smoothed->plane);
    content.start = result.raw.plane.waypoints().front();
    content.goal = result.raw.plane.waypoints().back();
    content.title = summaryLine(options, result) + "\n" + "chart " + chartNames(*result.chart) + ", " +
                    toString(options.from) + " to " + toString(options.to);
    content.footer = "not for navigation";
    try
    {
        seahex::writePicture(options.picture, content);
    }
    catch (const seahex::PictureError &error)
    {
        throw demos::Failure(demos::Exit::Usage, error.what());
    }
}

}  // namespace plan_route
