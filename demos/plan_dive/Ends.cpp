#include "Ends.h"

#include "WrittenDive.h"
#include "common/Failure.h"

#include <seahex/world/SegmentValidity.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plan_dive
{
namespace
{

using demos::plain;
using seahex::GeoPoint;

/// Metres to the centimetre.
std::string metres(double value)
{
    return plain(std::floor(value * 100.0) / 100.0) + " m";
}

std::string boundsOf(const Seabed &seabed)
{
    const seahex::Box &bounds = seabed.depths->grid().bounds();
    return toString(seabed.projection.inverse(bounds.min)) + " to " + toString(seabed.projection.inverse(bounds.max));
}

/// What depths would do at a place with so much water; empty if the one asked for does.
/// @param aboveCablesM  that the seabed counts as higher where cables lie
std::string depthFault(const seahex::DiveLimits &limits, double seabedM, double depthM, double aboveCablesM)
{
    const double lowest = std::min(seabedM - limits.clearanceM - seahex::DiveArena::roundingM, limits.deepestM);
    if (depthM >= limits.ceilingM && depthM <= lowest)
        return "";
    std::string fault =
        depthM < limits.ceilingM ? "above the ceiling of " + plain(limits.ceilingM) + " m"
        : depthM > limits.deepestM
            ? "below the greatest depth of " + plain(limits.deepestM) + " m"
            : "too deep: the seabed lies at " + metres(seabedM) + " and " + plain(limits.clearanceM) +
                  " m of clearance are wanted (" + plain(writingInHandM) + " m of it for the rounding of positions)" +
                  (aboveCablesM > 0.0 ? "; where cables lie it counts as " + plain(aboveCablesM) + " m higher" : "");
    return fault + (lowest >= limits.ceilingM
                        ? "; " + plain(limits.ceilingM) + " m to " + metres(lowest) + " would do there"
                        : "; no depth would do there, where the seabed lies at " + metres(seabedM));
}

std::string chartFault(const Seabed &seabed, const seahex::Point &p)
{
    if (!seabed.around || isFree(*seabed.around->occupancy(), p, p))
        return "";
    std::vector<std::string> reasons = seabed.around->explainPoint(p);
    if (reasons.empty())
        reasons = seabed.around->explainCell(seabed.around->occupancy()->lattice().cellAt(p));
    return reasons.empty() ? "it touches the edge of a blocked cell or of the chart" : reasons.front();
}

}  // namespace

seahex::Point3 endInWater(const Seabed &seabed, const seahex::DiveArena &arena, const DivePosition &position,
                          const std::string &role)
{
    const std::string who = role + " " + toString(position.place) + " at " + plain(position.depthM) + " m";
    const auto refuse = [&](const std::string &why)
    {
        throw demos::Failure(demos::Exit::NotNavigable, who + " " + why);
    };
    const seahex::Point p = seabed.projection.forward(position.place);
    if (!seabed.depths->grid().bounds().contains(p))
        refuse("lies outside the seabed that is known, " + boundsOf(seabed));
    const double depthM = seabed.depths->depthAt(p);
    if (!std::isfinite(depthM))
        refuse("lies where the depth of the seabed is unknown");
    if (depthM + seabed.aboveCablesM <= 0.0)
        refuse("lies on land, " + metres(-depthM) + " above the datum");
    if (const std::string fault = depthFault(arena.limits(), depthM, position.depthM, seabed.aboveCablesM);
        !fault.empty())
        refuse("is " + fault);
    if (const std::string fault = chartFault(seabed, p); !fault.empty())
        refuse("is not navigable: " + fault);
    const seahex::Point3 inWater(p.x(), p.y(), position.depthM);
    if (!arena.isFree(inWater))
        refuse("is not free");
    return inWater;
}

}  // namespace plan_dive
