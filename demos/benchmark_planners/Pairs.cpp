#include "Pairs.h"

#include "common/Failure.h"

#include <seahex/world/SegmentValidity.h>

#include <cmath>
#include <optional>
#include <random>

namespace benchmark_planners
{
namespace
{

using seahex::Point;

constexpr double fullTurnDeg = 360.0;

/// Uniform numbers whose sequence the standard fixes, unlike that of its distributions.
class Uniform
{
public:
    explicit Uniform(std::uint32_t seed) : engine_(seed) {}

    double between(double low, double high)
    {
        const double share = static_cast<double>(engine_() >> 11) * 0x1p-53;
        return low + (high - low) * share;
    }

private:
    std::mt19937_64 engine_;
};

class PairDrawer
{
public:
    PairDrawer(const seahex::HexOccupancy &occupancy, const LargestWater &water, const PairRules &rules)
        : occupancy_(occupancy), water_(water), rules_(rules), box_(occupancy.lattice().bounds()), uniform_(rules.seed)
    {
    }

    std::vector<Pair> draw()
    {
        std::vector<Pair> pairs;
        for (unsigned k = 0; k < rules_.count; ++k)
        {
            const double sectorDeg = fullTurnDeg / rules_.count;
            pairs.push_back(drawWithin(k * sectorDeg, (k + 1) * sectorDeg));
            pairs.back().number = k + 1;
        }
        return pairs;
    }

private:
    Pair drawWithin(double fromDeg, double toDeg)
    {
        constexpr int mostTries = 1000000;
        for (int i = 0; i < mostTries; ++i)
            if (const std::optional<Pair> pair = tryOnce(fromDeg, toDeg))
                return *pair;
        throw demos::Failure(demos::Exit::NotNavigable,
                             "no start and goal were found with a course between " + demos::plain(fromDeg) + " and " +
                                 demos::plain(toDeg) +
                                 " degrees, in the chart's largest water, with no straight way, " +
                                 "and far enough apart; a smaller --least-distance may help");
    }

    std::optional<Pair> tryOnce(double fromDeg, double toDeg)
    {
        const double diagonal = (box_.max - box_.min).norm();
        Pair pair;
        pair.start = Point(uniform_.between(box_.min.x(), box_.max.x()), uniform_.between(box_.min.y(), box_.max.y()));
        const double course = uniform_.between(fromDeg, toDeg) * M_PI / 180.0;
        const double distance = uniform_.between(rules_.leastDistance * diagonal, diagonal);
        pair.goal = pair.start + distance * Point(std::sin(course), std::cos(course));
        const bool isPair =
            isInWater(pair.start) && isInWater(pair.goal) && !seahex::isFree(occupancy_, pair.start, pair.goal);
        return isPair ? std::optional<Pair>(pair) : std::nullopt;
    }

    bool isInWater(const Point &p) const
    {
        return water_.contains(occupancy_.lattice().cellAt(p)) && seahex::isFree(occupancy_, p, p);
    }

    const seahex::HexOccupancy &occupancy_;
    const LargestWater &water_;
    PairRules rules_;
    seahex::Box box_;
    Uniform uniform_;
};

}  // namespace

double Pair::courseDeg() const
{
    const Point d = goal - start;
    const double course = std::atan2(d.x(), d.y()) * 180.0 / M_PI;
    return course < 0.0 ? course + fullTurnDeg : course;
}

std::vector<Pair> drawPairs(const seahex::HexOccupancy &occupancy, const LargestWater &water, const PairRules &rules)
{
    return PairDrawer(occupancy, water, rules).draw();
}

}  // namespace benchmark_planners
