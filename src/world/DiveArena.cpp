#include "seahex/world/DiveArena.h"

#include "seahex/world/SegmentValidity.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace seahex
{
namespace
{

Point3 at(const Point &p, double z)
{
    return {p.x(), p.y(), z};
}

}  // namespace

DiveArena::DiveArena(std::shared_ptr<const Bathymetry> seabed, const DiveLimits &limits,
                     std::shared_ptr<const Occupancy> keepOut)
    : seabed_(std::move(seabed)), keepOut_(std::move(keepOut)), limits_(limits)
{
    if (!(limits.clearanceM >= 0.0) || !(limits.ceilingM >= 0.0) || !(limits.deepestM >= 0.0))
        throw std::domain_error("a dive's clearance, ceiling and greatest depth must be numbers and not negative");
    const double greatest = std::min(seabed_->greatestDepth() - limits.clearanceM - roundingM, limits.deepestM);
    if (!(greatest > limits.ceilingM))
        throw std::runtime_error("nowhere is water enough to dive at " + std::to_string(limits.ceilingM) + " m with " +
                                 std::to_string(limits.clearanceM) + " m of clearance: the seabed lies at " +
                                 std::to_string(seabed_->greatestDepth()) + " m at the deepest");
    lowest_ = at(seabed_->grid().bounds().min, limits.ceilingM);
    highest_ = at(seabed_->grid().bounds().max, greatest);
}

bool DiveArena::isFree(const Point3 &p) const
{
    const Point place = horizontal(p);
    return isWithinDepths(p) && seabed_->depthAt(place) - p.z() >= limits_.clearanceM + roundingM &&
           (keepOut_ == nullptr || seahex::isFree(*keepOut_, place, place));
}

bool DiveArena::isFree(const Point3 &a, const Point3 &b) const
{
    const double needed = limits_.clearanceM + roundingM;
    return isWithinDepths(a) && isWithinDepths(b) && seabed_->leastWaterBelow(a, b, needed) >= needed &&
           (keepOut_ == nullptr || seahex::isFree(*keepOut_, horizontal(a), horizontal(b)));
}

double DiveArena::room(const Point3 &p) const
{
    const double below = seabed_->depthAt(horizontal(p)) - limits_.clearanceM - roundingM - p.z();
    return std::min({below, p.z() - limits_.ceilingM, limits_.deepestM - p.z()});
}

}  // namespace seahex
