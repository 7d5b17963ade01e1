#include "DivePairs.h"

#include "DeepWater.h"
#include "Failure.h"
#include "Uniform.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace demos
{
namespace
{

using seahex::Point;
using seahex::Point3;

class DivePairDrawer
{
public:
    DivePairDrawer(const seahex::DiveArena &arena, const PairRules &rules)
        : arena_(arena), rules_(rules), box_(arena.seabed()->grid().bounds()),
          water_(*arena.seabed(), arena.limits().ceilingM + arena.limits().clearanceM + seahex::DiveArena::roundingM),
          uniform_(rules.seed)
    {
    }

    std::vector<DivePair> draw()
    {
        std::vector<DivePair> pairs;
        const double sectorDeg = 360.0 / rules_.count;
        for (unsigned k = 0; k < rules_.count; ++k)
        {
            pairs.push_back(drawWithin(k * sectorDeg, (k + 1) * sectorDeg));
            pairs.back().number = k + 1;
        }
        return pairs;
    }

private:
    DivePair drawWithin(double fromDeg, double toDeg)
    {
        constexpr int mostTries = 1000000;
        constexpr int mostCandidates = 100;
        std::optional<DivePair> first;
        int candidates = 0;
        for (int i = 0; i < mostTries && candidates < mostCandidates; ++i)
        {
            const std::optional<DivePair> pair = tryOnce(fromDeg, toDeg);
            if (!pair)
                continue;
            if (pair->isSeabedInTheWay || !rules_.needsDetour)
                return *pair;
            ++candidates;
            first = first ? first : pair;
        }
        if (!first)
            throw Failure(Exit::NotNavigable, "no start and goal were found with a course between " + plain(fromDeg) +
                                                  " and " + plain(toDeg) + " degrees, over the largest water that is " +
                                                  "deep enough, and far enough apart; a smaller --least-distance may " +
                                                  "help");
        return *first;
    }

    std::optional<DivePair> tryOnce(double fromDeg, double toDeg)
    {
        const double diagonal = (box_.max - box_.min).norm();
        const Point start(uniform_.between(box_.min.x(), box_.max.x()), uniform_.between(box_.min.y(), box_.max.y()));
        const double course = uniform_.between(fromDeg, toDeg) * M_PI / 180.0;
        const double distance = uniform_.between(rules_.leastDistance * diagonal, diagonal);
        const Point goal = start + distance * Point(std::sin(course), std::cos(course));
        if (!water_.contains(start) || !water_.contains(goal))
            return std::nullopt;
        DivePair pair;
        pair.start = anyDepthAt(start);
        pair.goal = anyDepthAt(goal);
        if (!arena_.isFree(pair.start) || !arena_.isFree(pair.goal))
            return std::nullopt;
        pair.isSeabedInTheWay = !arena_.isFree(pair.start, pair.goal);
        return pair;
    }

    Point3 anyDepthAt(const Point &p)
    {
        const seahex::DiveLimits &limits = arena_.limits();
        const double lowest = std::min(arena_.seabed()->depthAt(p) - limits.clearanceM, limits.deepestM);
        return {p.x(), p.y(), uniform_.between(limits.ceilingM, lowest)};
    }

    const seahex::DiveArena &arena_;
    PairRules rules_;
    seahex::Box box_;
    DeepWater water_;
    Uniform uniform_;
};

}  // namespace

std::vector<DivePair> drawDivePairs(const seahex::DiveArena &arena, const PairRules &rules)
{
    return DivePairDrawer(arena, rules).draw();
}

}  // namespace demos
