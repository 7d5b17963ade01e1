#pragma once

#include <seahex/geometry/Shape.h>

#include "support/Random.h"

namespace seahex::test
{

/// A simple ring about a centre, concave more often than not, stored in either orientation. Now and then it is squeezed
/// to a sliver.
/// @param radius  of the circle that holds it
Ring randomRing(Random &random, const Point &centre, double radius);

/// A ring inside another one, about the same centre.
Ring ringWithin(Random &random, const Ring &ring, const Point &centre);

/// An area with or without a hole (a lake), in the plane around a centre. @param island  gets an area within the lake
Polygon randomArea(Random &random, const Point &centre, double radius, bool withHole, Polygon *island = nullptr);

/// A ring of random corners that most often crosses itself.
Ring crossedRing(Random &random, const Box &box);

}  // namespace seahex::test
