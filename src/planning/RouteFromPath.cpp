#include "seahex/planning/RouteFromPath.h"

#include "seahex/planning/PlanarEmbedding.h"

#include <ompl/base/SpaceInformation.h>

#include <utility>

namespace seahex
{

Route routeFromPath(const ompl::geometric::PathGeometric &path)
{
    const PlanarEmbedding embedding(path.getSpaceInformation()->getStateSpace().get());
    std::vector<Point> waypoints;
    for (std::size_t i = 0; i < path.getStateCount(); ++i)
    {
        const Point p = embedding.position(path.getState(static_cast<unsigned int>(i)));
        if (waypoints.empty() || waypoints.back() != p)
            waypoints.push_back(p);
    }
    return Route(std::move(waypoints));
}

}  // namespace seahex
