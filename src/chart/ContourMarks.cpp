#include "ContourMarks.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace seahex
{
namespace
{

/// Marks in the order in which their cells were first met, which makes a surface of them repeatable.
class MarkByCell
{
public:
    explicit MarkByCell(const NodeGrid &grid) : grid_(grid) {}

    void add(const Point &p, double depthM)
    {
        if (!grid_.bounds().contains(p))
            return;
        const Point steps = grid_.steps(p);
        const auto cell = static_cast<std::int64_t>(steps.y()) * grid_.columns() + static_cast<std::int64_t>(steps.x());
        const auto [known, isNew] = index_.try_emplace(cell, marks_.size());
        if (isNew)
            marks_.push_back({p, depthM});
        else if (depthM < marks_[known->second].depthM)
            marks_[known->second] = {p, depthM};
    }

    std::vector<PlaneSounding> take() { return std::move(marks_); }

private:
    const NodeGrid &grid_;
    std::unordered_map<std::int64_t, std::size_t> index_;
    std::vector<PlaneSounding> marks_;
};

}  // namespace

std::vector<PlaneSounding> contourMarks(const std::vector<PlaneContour> &contours, const NodeGrid &grid)
{
    const double spacing = grid.spacing().minCoeff();
    MarkByCell marks(grid);
    for (const PlaneContour &contour : contours)
        forEachSegment(contour.shape,
                       [&](const Point &a, const Point &b)
                       {
                           const double steps = std::max(1.0, std::ceil((b - a).norm() / spacing));
                           for (double i = 0.0; i <= steps; ++i)
                               marks.add(a + i / steps * (b - a), contour.depthM);
                       });
    return marks.take();
}

}  // namespace seahex
