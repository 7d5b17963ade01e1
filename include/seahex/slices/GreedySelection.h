#pragma once

#include <seahex/slices/SliceSearch.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace seahex
{

/// The selection of [Xu] eq. 6-9: plane by plane the open point with the least L = Lj + Lk, Lj its distance from the
/// point before, Lk its distance from where the reference line meets the plane. The reference line leads from the
/// newest point to the goal.
///
/// One point more than published: the leg to a point must be valid, else the next best is tried. Without that the
/// published selection may leap through a ridge between two planes. Of equal L the first in the order of the grid is
/// taken. It never goes back: where no point can be reached it ends in a dead end behind farthestPlane(), which says
/// nothing about other paths. Danger counts only where it is 1.
class GreedySelection : public SliceSearch
{
public:
    explicit GreedySelection(const SliceProblem &problem);
    Step work(LegJudge &judge) override;

private:
    void rank();

    Eigen::Vector3d newest_;
    int plane_ = 1;
    SlicePath chosen_;
    std::vector<std::pair<double, std::size_t>> ranking_;  // L and index of the plane's open points, the best first
    std::size_t next_ = 0;                                 // of the ranking
    bool isDone_ = false;
};

}  // namespace seahex
