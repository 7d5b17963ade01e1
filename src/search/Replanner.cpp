#include "seahex/search/Replanner.h"

#include <algorithm>
#include <limits>

namespace seahex
{

Replanner::Replanner(std::shared_ptr<const Occupancy> occupancy, int rings)
    : occupancy_(std::move(occupancy)), rings_(rings), fromGoal_(occupancy_, rings)
{
}

void Replanner::setOccupancy(const std::shared_ptr<const Occupancy> &occupancy)
{
    // a tree that grows from an end of old is not worth its repair
    if (ends_ && fromGoal_.root() != ends_->goal)
        fromGoal_.clear();
    if (fromStart_ && fromStart_->root() != ends_->start)
        fromStart_->clear();
    fromGoal_.setOccupancy(occupancy);
    if (fromStart_)
        fromStart_->setOccupancy(occupancy);
    occupancy_ = occupancy;
    isFound_ = false;
}

SearchStatus Replanner::plan(HexCoord start, HexCoord goal, const std::function<bool()> &stop)
{
    isFromStart_ = useTreeFor(start, goal);
    ends_ = Ends{start, goal};
    const SearchStatus status = isFromStart_ ? fromStart_->growTo(goal, stop) : fromGoal_.growTo(start, stop);
    isFound_ = status == SearchStatus::Found;
    return status;
}

/// Sees to it that a tree has its root at one of the ends. @return whether it is the one from the start
bool Replanner::useTreeFor(HexCoord start, HexCoord goal)
{
    if (fromGoal_.root() == goal)
        return false;
    if (fromStart_ && fromStart_->root() == start)
        return true;
    if (ends_ && ends_->start == start)
    {
        plantAtStart(start);
        return true;
    }
    fromGoal_.plant(goal);
    return false;
}

void Replanner::plantAtStart(HexCoord start)
{
    if (!fromStart_)
        fromStart_ = std::make_unique<LengthTree>(occupancy_, rings_);
    fromStart_->plant(start);
}

SearchStatus Replanner::prepareForGoals(const std::function<bool()> &stop)
{
    if (!ends_)
        return SearchStatus::Exhausted;
    if (!fromStart_ || fromStart_->root() != ends_->start)
        plantAtStart(ends_->start);
    return fromStart_->growTo(ends_->goal, stop);
}

double Replanner::length() const
{
    if (!isFound_)
        return std::numeric_limits<double>::infinity();
    return isFromStart_ ? fromStart_->length(ends_->goal) : fromGoal_.length(ends_->start);
}

std::vector<CellIndex> Replanner::path() const
{
    if (!isFound_)
        return {};
    if (isFromStart_)
        return fromStart_->path(ends_->goal);
    std::vector<CellIndex> cells = fromGoal_.path(ends_->start);
    std::reverse(cells.begin(), cells.end());
    return cells;
}

}  // namespace seahex
