#include "seahex/planning/SlicePlanner.h"

#include "planning/EndStates.h"
#include "planning/SliceQuery.h"

#include <ompl/util/Exception.h>

#include <sstream>

// What may be set on a planner on slices.

namespace seahex
{

void SlicePlanner::requireRange(const std::string &parameter, double value, double low, double high) const
{
    if (value >= low && value <= high)
        return;
    std::ostringstream text;
    text << parameter << " must be from " << low << " to " << high << ", not " << value;
    throw ompl::Exception(getName(), text.str());
}

void SlicePlanner::setSlices(unsigned int planes)
{
    requireRange("slices", planes, 2.0, 1000.0);
    resolution_.planes = static_cast<int>(planes);
    forgetSearch();
}

void SlicePlanner::setAcross(unsigned int points)
{
    requireRange("across", points, 2.0, 1000.0);
    resolution_.across = static_cast<int>(points);
    forgetSearch();
}

void SlicePlanner::setLevels(unsigned int levels)
{
    requireRange("levels", levels, 2.0, 1000.0);
    resolution_.levels = static_cast<int>(levels);
    forgetSearch();
}

void SlicePlanner::setAxis(SliceAxis axis)
{
    axis_ = axis;
    forgetSearch();
}

void SlicePlanner::setAxis(const std::string &axis)
{
    if (axis == "course")
        setAxis(SliceAxis::Course);
    else if (axis == "x")
        setAxis(SliceAxis::X);
    else if (axis == "y")
        setAxis(SliceAxis::Y);
    else
        throw ompl::Exception(getName(), "axis must be course, x or y, not '" + axis + "'");
}

std::string SlicePlanner::getAxis() const
{
    return axis_ == SliceAxis::Course ? "course" : axis_ == SliceAxis::X ? "x" : "y";
}

void SlicePlanner::setNeighbourhood(unsigned int side)
{
    requireRange("neighbourhood", side, 3.0, 9.0);
    if (side % 2 == 0)
        throw ompl::Exception(getName(), "neighbourhood must be odd");
    criterion_.neighbourhood = static_cast<int>(side);
    forgetSearch();
}

void SlicePlanner::setLengthWeight(double weight)
{
    requireRange("K", weight, 0.0, 1.0);
    criterion_.lengthWeight = weight;
    forgetSearch();
}

void SlicePlanner::setVehicleLength(double length)
{
    requireRange("vehicle_length", length, 1e-3, 1e6);
    criterion_.vehicleLength = length;
    forgetSearch();
}

void SlicePlanner::setInflate(bool inflate)
{
    inflate_ = inflate;
    forgetSearch();
}

void SlicePlanner::setOptimise(bool optimise)
{
    optimise_ = optimise;
    forgetSearch();
}

}  // namespace seahex
