#pragma once

#include "seahex/search/Jumps.h"

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
inline std::vector<double> coursesOf(const Jumps &jumps)
{
    std::vector<double> courses;
    for (std::size_t k = 0; k < jumps.size(); ++k)
        courses.push_back(courseBetween(Point::Zero(), jumps.vector(k)));
    return courses;
}

}  // namespace seahex
