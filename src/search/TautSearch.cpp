#include "seahex/search/TautSearch.h"

#include "seahex/route/CornerOffset.h"
#include "search/TautExpansion.h"

namespace seahex
{

TautSearch::TautSearch(const HexOccupancy &occupancy) : expansion_(std::make_unique<Expansion>(occupancy)) {}
TautSearch::~TautSearch() = default;
TautSearch::TautSearch(TautSearch &&) noexcept = default;
TautSearch &TautSearch::operator=(TautSearch &&) noexcept = default;

void TautSearch::begin(const Point &start, const Point &goal, double bound)
{
    expansion_->begin(start, goal, bound);
}

SearchStatus TautSearch::run(const std::function<bool()> &stop, std::uint64_t pollInterval)
{
    std::uint64_t untilPoll = 0;
    while (!expansion_->isFinished())
    {
        if (untilPoll-- == 0)
        {
            if (stop())
                return SearchStatus::Stopped;
            untilPoll = pollInterval - 1;
        }
        expansion_->step();
    }
    return expansion_->hasPath() ? SearchStatus::Found : SearchStatus::Exhausted;
}

double TautSearch::lowerBound() const
{
    return expansion_->lowerBound();
}

bool TautSearch::hasPath() const
{
    return expansion_->hasPath();
}

double TautSearch::length() const
{
    return expansion_->length();
}

std::vector<Point> TautSearch::path() const
{
    return expansion_->path();
}

Route TautSearch::route() const
{
    return offsetFromCorners(Route(path()), expansion_->occupancy()).value_or(Route());
}

bool TautSearch::isOptimal(double length) const
{
    constexpr double tolerance = 2e-6;
    const double least = lowerBound();
    return length <= least + tolerance * (least + expansion_->occupancy().lattice().pitch());
}

std::uint64_t TautSearch::expanded() const
{
    return expansion_->expanded();
}

std::size_t TautSearch::cornerCount() const
{
    return expansion_->cornerCount();
}

}  // namespace seahex
