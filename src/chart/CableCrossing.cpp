#include "seahex/chart/CableCrossing.h"

#include "seahex/chart/ChartArena.h"
#include "seahex/world/RaisedSeabed.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace seahex
{
namespace
{

bool isCable(const HazardObject &object)
{
    return object.rule == HazardRule::Cable || object.objectClass == "CBLARE";
}

}  // namespace

std::shared_ptr<const Bathymetry> raiseCables(const Bathymetry &seabed, const Chart &chart,
                                              const Projection &projection, double heightM, double marginM)
{
    if (!projection.isMetric())
        throw std::domain_error("cables can't be raised in a frame of degrees");
    if (!(marginM >= 0.0) || !std::isfinite(marginM))
        throw std::domain_error("a margin of " + std::to_string(marginM) + " m is none");
    const double scale = projection.largestScale(seabed.grid().bounds());
    std::vector<LyingObject> cables;
    for (const GeoHazard &hazard : chart.hazards)
        if (isCable(*hazard.object))
            cables.push_back({projection.forward(hazard.shape),
                              (std::max(hazard.object->radiusM, marginM) + ChartArena::growthM) * scale,
                              hazard.object->value("DRVAL1")});
    return raisedSeabed(seabed, cables, heightM);
}

}  // namespace seahex
