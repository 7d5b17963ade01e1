#include "seahex/slices/AntColonySearch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace seahex
{
namespace
{

constexpr double leastTrail = 1e-6;

}  // namespace

AntColonySearch::AntColonySearch(const SliceProblem &problem, const AntSettings &settings)
    : SliceSearch(problem), settings_(settings), engine_(settings.seed),
      trail_(static_cast<std::size_t>(frame().planes()) * frame().cellCount(), 1.0),
      bestTotal_(std::numeric_limits<double>::infinity())
{
}

Eigen::Vector3d AntColonySearch::positionOf(int plane, std::size_t index) const
{
    return plane == 0             ? frame().start()
           : plane == lastPlane() ? frame().goal()
                                  : frame().position(plane, frame().cell(index));
}

SliceSearch::Step AntColonySearch::work(LegJudge &judge)
{
    while (iteration_ < settings_.iterations)
    {
        for (; ant_ < settings_.ants; ++ant_)
        {
            const std::mt19937_64 before = engine_;
            SlicePath path;
            const Walk walked = judge.isOver() ? Walk::Interrupted : walk(judge, path);
            if (walked == Walk::Interrupted)
            {
                engine_ = before;  // it will set out again and go the same way, past legs that are judged by then
                return Step::Interrupted;
            }
            if (walked == Walk::Lost)
                continue;
            const double total = problem().figures(path).total;
            arrived_.push_back({path, total});
            if (total < bestTotal_)
            {
                bestTotal_ = total;
                best_ = std::move(path);
                ++ant_;
                return Step::Better;
            }
        }
        updateTrails();
        ant_ = 0;
        ++iteration_;
    }
    return Step::Done;
}

AntColonySearch::Walk AntColonySearch::walk(LegJudge &judge, SlicePath &path)
{
    std::size_t from = 0;
    for (int plane = 1; plane <= lastPlane(); ++plane)
    {
        gatherChoices(plane, positionOf(plane - 1, from));
        for (bool isThere = false; !isThere;)
        {
            if (choices_.empty())
                return Walk::Lost;
            const std::size_t drawn = draw();
            const std::size_t to = choices_[drawn].first;
            const LegJudge::Answer answer = judgeLeg(judge, plane, from, to);
            if (answer == LegJudge::Answer::Interrupted)
                return Walk::Interrupted;
            isThere = answer == LegJudge::Answer::Valid;
            if (isThere)
                from = to;
            else
                choices_.erase(choices_.begin() + static_cast<std::ptrdiff_t>(drawn));
        }
        farthest_ = std::max(farthest_, plane);
        if (plane < lastPlane())
            path.push_back(frame().cell(from));
    }
    return Walk::Arrived;
}

void AntColonySearch::gatherChoices(int plane, const Eigen::Vector3d &from)
{
    choices_.clear();
    if (plane == lastPlane())
    {
        choices_.emplace_back(0, 1.0);  // the goal
        return;
    }
    const Eigen::Vector2d at = frame().gridCoordinates(from);
    const auto first = [&](int k)
    {
        return std::max(0, static_cast<int>(std::ceil(at[k] - settings_.reach - 1e-9)));
    };
    const auto last = [&](int k, int count)
    {
        return std::min(count - 1, static_cast<int>(std::floor(at[k] + settings_.reach + 1e-9)));
    };
    for (int across = first(0); across <= last(0, frame().across()); ++across)
        for (int level = first(1); level <= last(1, frame().levels()); ++level)
        {
            const std::size_t index = frame().index({across, level});
            if (!problem().isOpen(plane, index))
                continue;
            const Eigen::Vector3d point = frame().position(plane, {across, level});
            const double visibility =
                (1.0 - problem().danger(plane, index)) / ((point - from).norm() + (frame().goal() - point).norm());
            // in steps, so that no power of a small number vanishes
            const double odds = std::pow(trailAt(plane, {across, level}), settings_.alpha) *
                                std::pow(visibility * frame().spacing(), settings_.beta);
            choices_.emplace_back(index, std::max(odds, std::numeric_limits<double>::min()));
        }
}

std::size_t AntColonySearch::draw()
{
    const double sum = std::accumulate(choices_.begin(), choices_.end(), 0.0,
                                       [](double before, const auto &choice) { return before + choice.second; });
    double left = static_cast<double>(engine_() >> 11) * 0x1p-53 * sum;  // the same with every standard library
    std::size_t drawn = 0;
    while (drawn + 1 < choices_.size() && left >= choices_[drawn].second)
        left -= choices_[drawn++].second;
    return drawn;
}

LegJudge::Answer AntColonySearch::judgeLeg(LegJudge &judge, int plane, std::size_t from, std::size_t to)
{
    const std::uint64_t points = frame().cellCount();
    const std::uint64_t leg = (static_cast<std::uint64_t>(plane) * points + from) * points + to;
    const auto known = legs_.find(leg);
    if (known != legs_.end())
        return known->second ? LegJudge::Answer::Valid : LegJudge::Answer::Invalid;
    const LegJudge::Answer answer = judge.judge(positionOf(plane - 1, from), positionOf(plane, to));
    if (answer != LegJudge::Answer::Interrupted)
        legs_.emplace(leg, answer == LegJudge::Answer::Valid);
    return answer;
}

void AntColonySearch::updateTrails()
{
    for (double &trail : trail_)
        trail = std::max(leastTrail, (1.0 - settings_.evaporation) * trail);
    const auto lay = [&](const SlicePath &path, double amount)
    {
        for (std::size_t i = 0; i < path.size(); ++i)
            trailAt(static_cast<int>(i) + 1, path[i]) += amount;
    };
    for (const Trail &ant : arrived_)
        lay(ant.path, ant.total > 0.0 ? bestTotal_ / ant.total : 1.0);
    if (best_)
        lay(*best_, settings_.elite);
    arrived_.clear();
}

}  // namespace seahex
