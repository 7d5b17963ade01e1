#pragma once

#include <seahex/geometry/Point.h>
#include <seahex/route/Route.h>
#include <seahex/search/AStar.h>
#include <seahex/world/Occupancy.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace seahex
{

/// The shortest path among the blocked cells of a hexagonal lattice: any angle, any points, exact, with a lower bound
/// of its length from the first moment on.
///
/// An interval search as Anya [Harabor2016] and Polyanya [Cui2017], on the convex pieces that a hexagonal lattice has
/// by itself: each row's free cells are rectangles, and between two rows the tips of free cells form trapezoids. So
/// there is no mesh and nothing to prepare; the pieces are found in the occupancy's bits as the search comes by. A node
/// is an interval of a line between two pieces, all of it seen from one root: the start, or a corner of a blocked cell.
/// Corners wait in the same queue as intervals, so each is expanded once, when the way to it is known to be shortest,
/// and only where a taut path can turn around it.
///
/// The path found is that of closed free space: it goes through corners of blocked cells, where a valid motion may not
/// touch. Blocked hexagons never meet in a corner alone, so valid paths come as near to its length as one likes;
/// route() makes one.
///
/// Exact but for rounding: comparisons of places are exact for corners, as these have integer coordinates in the
/// search's frame, and lengths are sums of doubles, 1e-13 of the length or so.
///
/// What is dropped on the way: corners in which no taut path turns or beyond which there is but a pocket, and intervals
/// all of which a corner at their end reaches sooner than their root.
///
/// Memory: 40 bytes for every waiting node and as much for every corner that was seen; nothing a cell.
class TautSearch
{
public:
    static constexpr double unbounded = std::numeric_limits<double>::infinity();

    /// Does not own the occupancy, which must outlive the search. Holds memory for reuse between queries.
    explicit TautSearch(const HexOccupancy &occupancy);
    ~TautSearch();
    TautSearch(TautSearch &&) noexcept;
    TautSearch &operator=(TautSearch &&) noexcept;

    /// Forgets the last query and sets the next one. A start or goal that touches a blocked cell, lies outside or is
    /// not a number has no path.
    /// @param bound  paths of this length or longer are of no interest, as one is known
    void begin(const Point &start, const Point &goal, double bound = unbounded);

    /// Goes on until the shortest path is found, none is left that is shorter than the bound, or stop() returns true.
    /// stop() is asked before the first expansion and after every `pollInterval` of them.
    SearchStatus run(const std::function<bool()> &stop, std::uint64_t pollInterval);

    /// No path is shorter, whatever happened so far. Never falls but by rounding; the path's length once it is found;
    /// the bound, once all shorter paths are excluded (infinity: there is none at all).
    double lowerBound() const;

    bool hasPath() const;
    /// Length of the shortest path; infinity if none is known.
    double length() const;
    /// Start, the corners where the shortest path turns, goal; empty if none is known.
    std::vector<Point> path() const;

    /// A valid route as long but for a hair: path() moved off the corners by offsetFromCorners(), every leg checked.
    /// Empty if no path is known, or if start or goal lies too near to a blocked cell for its legs to be found free.
    Route route() const;

    /// Is a valid path of this length as short as any, by what is known so far? It may exceed the lower bound by two
    /// millionths of it and of the pitch, which
    /// covers what route() adds where cornerOffset() is a millionth of the pitch.
    bool isOptimal(double length) const;

    /// Nodes taken from the queue, outdated ones included.
    std::uint64_t expanded() const;
    /// Corners that were seen.
    std::size_t cornerCount() const;

private:
    class Expansion;
    std::unique_ptr<Expansion> expansion_;
};

}  // namespace seahex
