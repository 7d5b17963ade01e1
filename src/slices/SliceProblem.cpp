#include "seahex/slices/SliceProblem.h"

#include <numeric>

namespace seahex
{

SliceProblem::SliceProblem(const SliceStack &stack, const SliceCriterion &criterion)
    : stack_(stack), criterion_(criterion)
{
    danger_.reserve(static_cast<std::size_t>(frame().planes()) * frame().cellCount());
    for (int plane = 0; plane < frame().planes(); ++plane)
        for (std::size_t index = 0; index < frame().cellCount(); ++index)
        {
            const SliceCell cell = frame().cell(index);
            const bool isBlocked = stack_.isBlocked(plane, cell);
            danger_.push_back(isBlocked ? 1.0 : stack_.danger(plane, cell, criterion_.neighbourhood));
        }
}

std::vector<Eigen::Vector3d> SliceProblem::positions(const SlicePath &path) const
{
    std::vector<Eigen::Vector3d> points = {frame().start()};
    for (std::size_t i = 0; i < path.size(); ++i)
        points.push_back(frame().position(static_cast<int>(i) + 1, path[i]));
    points.push_back(frame().goal());
    return points;
}

SliceFigures SliceProblem::figures(const SlicePath &path) const
{
    std::vector<int> planes(path.size() + 2);
    std::iota(planes.begin(), planes.end(), 0);
    return figures(path, planes);
}

SliceFigures SliceProblem::figures(const SlicePath &path, const std::vector<int> &planes) const
{
    const std::vector<Eigen::Vector3d> points = positions(path);
    const auto at = [&](std::size_t i) -> const Eigen::Vector3d &
    {
        return points[static_cast<std::size_t>(planes[i])];
    };
    SliceFigures figures;
    for (std::size_t i = 1; i < planes.size(); ++i)
    {
        figures.length += (at(i) - at(i - 1)).norm() / criterion_.vehicleLength;
        if (i + 1 < planes.size())
            figures.danger += danger(planes[i], frame().index(path[static_cast<std::size_t>(planes[i]) - 1]));
    }
    figures.total = criterion_.lengthWeight * figures.length + (1.0 - criterion_.lengthWeight) * figures.danger;
    return figures;
}

}  // namespace seahex
