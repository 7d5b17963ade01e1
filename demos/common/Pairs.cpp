#include "Pairs.h"

#include "Failure.h"
#include "Uniform.h"

#include <seahex/world/SegmentValidity.h>

#include <cmath>
#include <optional>
#include <utility>

namespace demos
{
namespace
{

using seahex::Point;

constexpr double fullTurnDeg = 360.0;

class PairDrawer
{
public:
    /// A water of one lattice.
    struct Sea
    {
        const seahex::Occupancy *occupancy;
        const LargestWater *water;
    };

    PairDrawer(std::vector<Sea> seas, const PairRules &rules)
        : seas_(std::move(seas)), rules_(rules), box_(seas_.front().occupancy->lattice().bounds()), uniform_(rules.seed)
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
        throw Failure(Exit::NotNavigable, "no start and goal were found with a course between " + plain(fromDeg) +
                                              " and " + plain(toDeg) +
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
        for (const Sea &sea : seas_)
            if (!willDo(sea, pair))
                return std::nullopt;
        return pair;
    }

    bool willDo(const Sea &sea, const Pair &pair) const
    {
        const auto isInWater = [&sea](const Point &p)
        {
            return sea.water->contains(sea.occupancy->lattice().cellAt(p)) && seahex::isFree(*sea.occupancy, p, p);
        };
        return isInWater(pair.start) && isInWater(pair.goal) &&
               !(rules_.needsDetour && seahex::isFree(*sea.occupancy, pair.start, pair.goal));
    }

    std::vector<Sea> seas_;
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

std::vector<Pair> drawPairs(const seahex::Occupancy &occupancy, const LargestWater &water, const PairRules &rules)
{
    return PairDrawer({{&occupancy, &water}}, rules).draw();
}

std::vector<Pair> drawPairs(const std::vector<const seahex::Occupancy *> &occupancies, const PairRules &rules)
{
    std::vector<LargestWater> waters;
    waters.reserve(occupancies.size());
    std::vector<PairDrawer::Sea> seas;
    for (const seahex::Occupancy *occupancy : occupancies)
    {
        waters.emplace_back(*occupancy);
        seas.push_back({occupancy, &waters.back()});
    }
    return PairDrawer(std::move(seas), rules).draw();
}

}  // namespace demos
