#include "Figures.h"

namespace reproduce_papers
{
namespace
{

seahex::LineString lineOf(const seahex::Route &route)
{
    return seahex::LineString(route.waypoints().begin(), route.waypoints().end());
}

}  // namespace

Figure makeFigure(const std::string &name, const std::string &title, const Sea &sea, Cells cells,
                  const std::shared_ptr<const seahex::ChartArena> &arena, const Answer &answer,
                  const std::optional<seahex::Route> &smoothed)
{
    seahex::PictureContent content{arena->projection(), sea.sharedOccupancy(cells)};
    for (const seahex::Hazard &hazard : arena->hazards())
        if (hazard.object->objectClass == "LNDARE")
            content.land.push_back(&hazard.shape);
    content.expanded = answer.expanded;
    for (const seahex::Point &p : answer.path.waypoints())
        content.pathCells.push_back(content.occupancy->layout().index(content.occupancy->lattice().cellAt(p)));
    if (smoothed)
    {
        content.rawPath = lineOf(answer.path);
        content.route = lineOf(*smoothed);
        content.rawPathName = "path from centre to centre";
        content.routeName = "after smoothing";
    }
    else
    {
        content.route = lineOf(answer.path);
        content.routeName = "path from centre to centre";
    }
    content.start = answer.path.waypoints().front();
    content.goal = answer.path.waypoints().back();
    content.title = title;
    content.footer = "not for navigation";
    return {name, content, arena};
}

}  // namespace reproduce_papers
