#pragma once

#include <seahex/slices/SliceSearch.h>

#include <vector>

namespace seahex
{

/// The optimisation of [Xu] afterwards, from the goal backwards: a point is dropped when the segment that skips it
/// crosses every plane between its ends in a free cell; where it does not, the point before the goal stays, and the
/// same is done from there, until the start.
///
/// One question more than published: the segment must be a valid leg, not only meet free cells where it crosses planes.
/// The result's legs are legs of the path or were judged valid, in the path's direction; it is never longer, and never
/// more dangerous by F2, since points only go. It may differ for the reversed path, and is not the shortest. Asks once
/// for each point but two, at most.
class BackwardDropping
{
public:
    /// @param problem  must live as long as this
    BackwardDropping(const SliceProblem &problem, const SlicePath &path);

    /// @return false if the judge had no time: work() again continues
    bool work(LegJudge &judge);

    /// The planes whose points are kept, from the first to the last, when work is done.
    std::vector<int> planes() const;

private:
    bool crossesFreeCells(int from, int to) const;

    const SliceProblem &problem_;
    std::vector<Eigen::Vector3d> points_;
    std::vector<int> kept_;  // planes, from the last
    int next_;               // the plane to which the next segment leads
};

}  // namespace seahex
