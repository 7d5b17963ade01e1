#include "seahex/search/RelaxedGuide.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace seahex
{

RelaxedGuide::RelaxedGuide(std::shared_ptr<const Occupancy> occupancy, OffsetCoord start, OffsetCoord goal, int rings)
    : occupancy_(std::move(occupancy)), start_(toCube(start)), goal_(toCube(goal))
{
    useRings(rings);
}

void RelaxedGuide::useRings(int rings)
{
    rings_ = rings;
    distance_.reset();
    isSharp_ = false;
    const bool canHelp = occupancy_ && occupancy_->lattice().hexagons() != nullptr;
    patience_ = canHelp ? static_cast<std::uint64_t>(occupancy_->lattice().cellCount() / 128) : never;
}

bool RelaxedGuide::passLine()
{
    if (!distance_)
        distance_ = std::make_shared<RelaxedDistance>(occupancy_, start_, goal_, rings_);
    if (distance_->passNextLine())
        return false;
    patience_ = never;
    isSharp_ = true;
    return true;
}

double RelaxedGuide::raise(double bound, OffsetCoord cell) const
{
    if (!isSharp_)
        return bound;
    const double relaxed = (*distance_)(toCube(cell));
    return std::isfinite(relaxed) ? std::max(bound, relaxed) : bound;
}

}  // namespace seahex
