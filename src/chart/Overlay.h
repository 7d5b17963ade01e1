#pragma once

#include <seahex/geometry/Shape.h>

#include <vector>

namespace seahex
{

/// The union of the areas. A single area is returned as it is, bit for bit.
/// @return empty if the overlay fails
std::vector<Polygon> unite(const std::vector<Polygon> &areas);

/// What of `areas` is not covered by `others`; both may overlap themselves. Parts narrower than `widthDeg` are left
/// out.
/// @return false if the overlay fails
bool subtract(const std::vector<Polygon> &areas, const std::vector<Polygon> &others, double widthDeg,
              std::vector<Polygon> &rest);

/// True if the areas share more than a boundary.
bool overlap(const std::vector<Polygon> &a, const std::vector<Polygon> &b);

/// True if no ring crosses itself or another one of its area.
bool isSimple(const std::vector<Polygon> &areas);

/// Area in square degrees, whatever the orientation of the rings.
double areaDeg2(const std::vector<Polygon> &areas);

}  // namespace seahex
