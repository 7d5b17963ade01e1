#pragma once

#include "seahex/geometry/HexLattice.h"
#include "seahex/search/HexJumps.h"

#include <cmath>
#include <vector>

namespace seahex
{

/// The course from one point to another: radians, counter-clockwise from east.
inline double courseBetween(const Point &a, const Point &b)
{
    return std::atan2(b.y() - a.y(), b.x() - a.x());
}

/// The course of every jump.
inline std::vector<double> coursesOf(const HexJumps &jumps, const HexLattice &lattice)
{
    std::vector<double> courses;
    for (std::size_t k = 0; k < jumps.size(); ++k)
        courses.push_back(courseBetween(lattice.centre({0, 0}), lattice.centre(jumps.offset(k).offset)));
    return courses;
}

}  // namespace seahex
