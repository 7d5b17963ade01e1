#pragma once

#include "support/Random.h"

#include <seahex/slices/SliceSearch.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <vector>

namespace seahex::test
{

/// Between random places of a random box, along any axis.
inline SliceFrame randomFrame(Random &random, const SliceResolution &resolution)
{
    const Eigen::AlignedBox3d bounds(Eigen::Vector3d(-10.0, 5.0, 0.0),
                                     Eigen::Vector3d(random.real(0.0, 20.0), random.real(15.0, 30.0), 8.0));
    const auto place = [&]
    {
        Eigen::Vector3d p;
        for (int k = 0; k < 3; ++k)
            p[k] = random.real(bounds.min()[k], bounds.max()[k]);
        return p;
    };
    for (;;)
    {
        const auto axis = static_cast<SliceAxis>(random.integer(0, 2));
        const auto frame = SliceFrame::between(place(), place(), bounds, resolution, axis);
        if (frame && frame->spacing() > 0.1)
            return *frame;
    }
}

/// Each point blocked with the given probability.
inline SliceStack randomStack(Random &random, const SliceFrame &frame, double density)
{
    SliceStack stack(frame);
    for (int plane = 0; plane < frame.planes(); ++plane)
        for (std::size_t index = 0; index < frame.cellCount(); ++index)
            if (random.chance(density))
                stack.block(plane, frame.cell(index));
    return stack;
}

inline SliceCriterion randomCriterion(Random &random)
{
    const std::array<double, 4> weights = {0.0, 0.5, 1.0, random.unit()};
    SliceCriterion criterion;
    criterion.lengthWeight = weights[static_cast<std::size_t>(random.integer(0, 3))];
    criterion.vehicleLength = random.real(0.5, 3.0);
    criterion.neighbourhood = random.chance(0.8) ? 3 : 5;
    return criterion;
}

/// Judges legs by a rule of the test's, and remembers what it was asked. With `patience` it can be interrupted: after
/// so many questions it has no time until resume().
class RecordingJudge : public LegJudge
{
public:
    using Rule = std::function<bool(const Eigen::Vector3d &, const Eigen::Vector3d &)>;
    using Leg = std::array<double, 6>;

    explicit RecordingJudge(Rule rule, int patience = -1) : rule_(std::move(rule)), patience_(patience), left_(patience)
    {
    }

    Answer judge(const Eigen::Vector3d &from, const Eigen::Vector3d &to) override
    {
        if (left_ == 0)
            return Answer::Interrupted;
        --left_;
        ++asked_[{from.x(), from.y(), from.z(), to.x(), to.y(), to.z()}];
        return rule_(from, to) ? Answer::Valid : Answer::Invalid;
    }
    bool isOver() override { return left_ == 0; }
    void resume() { left_ = patience_; }

    std::size_t legs() const { return asked_.size(); }
    /// How often the same leg was asked for, at most.
    int mostRepeats() const
    {
        int most = 0;
        for (const auto &[leg, times] : asked_)
            most = std::max(most, times);
        return most;
    }

private:
    Rule rule_;
    int patience_;
    int left_;
    std::map<Leg, int> asked_;
};

inline RecordingJudge::Rule everyLeg()
{
    return [](const Eigen::Vector3d &, const Eigen::Vector3d &)
    {
        return true;
    };
}

/// Whether a leg is valid is drawn once for all from its ends: the same for whoever asks.
inline RecordingJudge::Rule randomLegs(Random &random, double validShare)
{
    const Eigen::Vector3d a(random.real(1.0, 50.0), random.real(1.0, 50.0), random.real(1.0, 50.0));
    const Eigen::Vector3d b(random.real(1.0, 50.0), random.real(1.0, 50.0), random.real(1.0, 50.0));
    return [a, b, validShare](const Eigen::Vector3d &from, const Eigen::Vector3d &to)
    {
        const double mixed = 997.0 * std::sin(from.dot(a) + to.dot(b));
        return mixed - std::floor(mixed) < validShare;
    };
}

/// Works until there is nothing better. @return the number of interruptions
inline int finish(SliceSearch &search, RecordingJudge &judge)
{
    for (int interruptions = 0;;)
        switch (search.work(judge))
        {
            case SliceSearch::Step::Better:
                break;
            case SliceSearch::Step::Done:
                return interruptions;
            case SliceSearch::Step::Interrupted:
                ++interruptions;
                judge.resume();
        }
}

/// Every leg of the path is valid and every point open.
inline void expectUsable(const SliceProblem &problem, const SlicePath &path, const RecordingJudge::Rule &isValid)
{
    ASSERT_EQ(path.size() + 2, static_cast<std::size_t>(problem.frame().planes()));
    const std::vector<Eigen::Vector3d> points = problem.positions(path);
    for (std::size_t i = 1; i < points.size(); ++i)
        EXPECT_TRUE(isValid(points[i - 1], points[i])) << "leg to plane " << i;
    for (std::size_t i = 0; i < path.size(); ++i)
        EXPECT_TRUE(problem.isOpen(static_cast<int>(i) + 1, problem.frame().index(path[i]))) << "plane " << i + 1;
}

}  // namespace seahex::test
