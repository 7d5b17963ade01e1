#pragma once

#include <seahex/geometry/Point.h>

#include <optional>
#include <string>

namespace seahex
{

/// What leads a search towards the goal.
enum class Guidance
{
    /// Whichever finds the best path soonest: on the hexagons of a chart, for lengths, from one start to one goal, the
    /// bound of Distance in a search made for just that (LengthSearch); elsewhere Relaxed.
    Automatic,
    None,       ///< nothing: Dijkstra's algorithm
    Distance,   ///< the exact lower bound of the length that remains
    Euclidean,  ///< the straight distance: the plain A* of [Wang2017]; weaker than Distance
    /// The published heuristic, D(i, E) p(i) of [Cheng2020] eq. 10. Never above D, so admissible for the metric D and
    /// for Euclidean costs on ring 1 and on squares; with Euclidean costs on rings 2 and 3 it overestimates (a jump of
    /// two rings can cost 1.73) and routes may be a few percent too long. Weaker than Distance: it expands more cells.
    Cheng,
    /// Straight distance times p(i), [Wang2017] eq. 5: admissible, consistent, and weaker than Euclidean.
    Wang,
    TieBreak,  ///< Distance; among cells of equal estimate the one nearest to the line from start to goal goes first
    /// Distance, and where the search drags on, the way round what lies across the course as well (RelaxedDistance):
    /// as exact, and it expands far fewer cells. On hexagons, for lengths, one goal and a known occupancy; elsewhere it
    /// is Distance.
    Relaxed
};

/// "automatic", "none", "distance", "euclidean", "cheng", "wang", "tie_break", "relaxed".
const char *toString(Guidance guidance);

/// The names of all, separated by commas.
std::string guidanceNames();

/// @return empty if the text names no guidance
std::optional<Guidance> guidanceFromString(const std::string &text);

/// The pilot quantity p(i) = 3 / (4 - sin theta), theta the angle at the goal between the start and i: [Cheng2020] eq.
/// 7 and 8. In [3/4, 1]; 1 where start and goal, or i and goal, coincide and the angle is undefined.
double pilotQuantity(const Point &start, const Point &goal, const Point &i);

/// Distance of a point from the straight line through start and goal; 0 if the two coincide.
double distanceFromLine(const Point &start, const Point &goal, const Point &p);

}  // namespace seahex
