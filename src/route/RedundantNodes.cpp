#include "seahex/route/RedundantNodes.h"

#include <utility>

namespace seahex
{

Route dropRedundantNodes(const Route &route, const SegmentPredicate &isValid)
{
    const std::vector<Point> &nodes = route.waypoints();
    if (nodes.size() < 3)
        return route;
    std::vector<Point> kept = {nodes.front()};
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        if (!isValid(kept.back(), nodes[i + 1]))
            kept.push_back(nodes[i]);
    kept.push_back(nodes.back());
    return Route(std::move(kept));
}

}  // namespace seahex
