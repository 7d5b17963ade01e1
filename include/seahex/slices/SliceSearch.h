#pragma once

#include <seahex/slices/SliceProblem.h>

#include <optional>

namespace seahex
{

/// Whom a search over slices asks: which legs may be travelled, and whether there is time left.
class LegJudge
{
public:
    enum class Answer
    {
        Valid,
        Invalid,
        Interrupted  ///< no time to say: to be asked again later
    };

    virtual ~LegJudge() = default;

    /// May the straight leg be travelled, in this direction? Both ends are valid places.
    virtual Answer judge(const Eigen::Vector3d &from, const Eigen::Vector3d &to) = 0;

    /// Looked at now and then by work that asks for no legs.
    virtual bool isOver() = 0;
};

/// A way to choose one point of every plane, so that each leg between them is valid. Works in steps, and may be
/// interrupted at any question without losing what it has done: the same path comes of it.
class SliceSearch
{
public:
    enum class Step
    {
        Better,      ///< best() is new
        Done,        ///< there will be nothing better
        Interrupted  ///< the judge has no time: work() again continues
    };

    virtual ~SliceSearch() = default;

    /// Goes on until there is a better path, or nothing more to do, or no time.
    virtual Step work(LegJudge &judge) = 0;

    const std::optional<SlicePath> &best() const { return best_; }
    /// The farthest plane that a way was found to; where there is no path, the dead end lies behind it.
    int farthestPlane() const { return farthest_; }

protected:
    /// @param problem  must live as long as the search
    explicit SliceSearch(const SliceProblem &problem) : problem_(problem) {}
    SliceSearch(const SliceSearch &) = default;

    const SliceProblem &problem() const { return problem_; }
    const SliceFrame &frame() const { return problem_.frame(); }
    int lastPlane() const { return frame().planes() - 1; }

    std::optional<SlicePath> best_;
    int farthest_ = 0;

private:
    const SliceProblem &problem_;
};

}  // namespace seahex
