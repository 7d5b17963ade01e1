#include "contest/ShortestPaths.h"

#include "contest/Median.h"
#include "contest/Stopwatch.h"

#include <seahex/route/RouteSmoother.h>
#include <seahex/route/StringPulling.h>
#include <seahex/search/LengthSearch.h>
#include <seahex/search/TautSearch.h>

#include <algorithm>
#include <stdexcept>

namespace seahex::contest
{
namespace
{

constexpr std::uint64_t pollInterval = 100000;

/// The length of the shortest path; leaves the search as it ended.
double solve(TautSearch &search, const HexLattice &lattice, const Query &query)
{
    search.begin(lattice.centre(query.start), lattice.centre(query.goal));
    if (search.run([] { return false; }, pollInterval) != SearchStatus::Found)
        throw std::runtime_error("TautSearch found no path");
    return search.length();
}

}  // namespace

double exactMs(const Course &course)
{
    const HexOccupancy &occupancy = *course.world().occupancy;
    TautSearch search(occupancy);
    std::vector<double> ms;
    for (const Query &query : course.queries())
    {
        const Stopwatch watch;
        solve(search, occupancy.lattice(), query);
        const Route route = search.route();
        ms.push_back(watch.ms());
        if (route.waypoints().empty() || !search.isOptimal(lengthOf(route.waypoints())))
            throw std::runtime_error("TautSearch has no valid path as short as its bound");
    }
    return medianOf(std::move(ms));
}

Gap gapOfPulled(const Course &course)
{
    const HexOccupancy &occupancy = *course.world().occupancy;
    const HexLattice &lattice = occupancy.lattice();
    TautSearch search(occupancy);
    LengthSearch chains(occupancy, 3);
    std::vector<double> percent;
    for (const Query &query : course.queries())
    {
        const double shortest = solve(search, lattice, query);
        chains.begin(query.start, query.goal);
        if (chains.run() != SearchStatus::Found)
            throw std::runtime_error("LengthSearch found no path");
        std::vector<Point> centres;
        for (const CellIndex cell : chains.path())
            centres.push_back(lattice.centre(chains.layout().cell(cell)));
        percent.push_back(100.0 * (lengthOf(pullString(Route(centres), occupancy).waypoints()) / shortest - 1.0));
    }
    return {medianOf(percent), *std::max_element(percent.begin(), percent.end())};
}

}  // namespace seahex::contest
