#include "seahex/route/Route.h"

#include <cmath>
#include <utility>

namespace seahex
{

double Leg::heading() const
{
    return std::atan2(to.y() - from.y(), to.x() - from.x());
}

Route::Route(std::vector<Point> waypoints) : waypoints_(std::move(waypoints)) {}

double Route::length() const
{
    double sum = 0.0;
    for (std::size_t i = 0; i < legCount(); ++i)
        sum += leg(i).length();
    return sum;
}

}  // namespace seahex
