#include <seahex/search/TurnBound.h>

#include <seahex/geometry/HexNorm.h>
#include <seahex/search/HexJumps.h>

#include "search/RandomTurnCosts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

const double pi = std::acos(-1.0);

Point vectorOf(HexCoord difference)
{
    return {static_cast<double>(difference.q) + 0.5 * static_cast<double>(difference.s),
            -0.5 * std::sqrt(3.0) * static_cast<double>(difference.s)};
}

/// Ring jumps in pitches, and a bound over them.
struct Rings
{
    int rings;
    TurnCosts turns;
    std::vector<HexCoord> offsets;
    std::vector<Point> jumps;
    std::vector<double> lengths;

    Rings(int r, JumpSet set, const TurnCosts &t) : rings(r), turns(t)
    {
        for (const RingOffset &offset : ringOffsets(r))
            if (set == JumpSet::All || offset.primitive)
            {
                offsets.push_back(offset.offset);
                jumps.push_back(vectorOf(offset.offset));
                lengths.push_back(jumps.back().norm());
            }
    }

    TurnBound bound() const { return {jumps, lengths, turns}; }
    double least(HexCoord difference, std::size_t heading) const
    {
        const TurnBound all = bound();
        return all(all.approach(vectorOf(difference), ringNorm(difference, rings)), heading);
    }

    double angle(std::size_t a, std::size_t b) const
    {
        const double turned = std::atan2(jumps[b].y(), jumps[b].x()) - std::atan2(jumps[a].y(), jumps[a].x());
        return std::abs(std::remainder(turned, 2.0 * pi));
    }

    double turn(std::size_t a, std::size_t b) const
    {
        return angle(a, b) > 1e-6 ? turns.perTurn + turns.perRadian * angle(a, b) : 0.0;
    }

    /// Length of a leg along a and one along b that add up to d; infinity if there are none.
    double length(const Point &d, std::size_t a, std::size_t b) const
    {
        const double area = jumps[a].x() * jumps[b].y() - jumps[a].y() * jumps[b].x();
        if (std::abs(area) < 1e-9)
            return std::numeric_limits<double>::infinity();
        const double m = (d.x() * jumps[b].y() - d.y() * jumps[b].x()) / area;
        const double n = (jumps[a].x() * d.y() - jumps[a].y() * d.x()) / area;
        return m < -1e-9 || n < -1e-9 ? std::numeric_limits<double>::infinity() : m * lengths[a] + n * lengths[b];
    }

    /// The relaxed problem by trying all: legs along the heading and one jump, or along any two jumps.
    double tryAll(HexCoord difference, std::size_t heading) const
    {
        const Point d = vectorOf(difference);
        double best = std::numeric_limits<double>::infinity();
        for (std::size_t a = 0; a < jumps.size(); ++a)
            for (std::size_t b = 0; b < jumps.size(); ++b)
            {
                const double first = heading < jumps.size() ? turn(heading, a) : 0.0;
                best = std::min(best, first + turn(a, b) + length(d, a, b));
            }
        // one leg
        for (std::size_t a = 0; a < jumps.size(); ++a)
            if ((d / d.norm() - jumps[a] / jumps[a].norm()).norm() < 1e-9)
                best = std::min(best, (heading < jumps.size() ? turn(heading, a) : 0.0) + d.norm());
        return best;
    }
};

HexCoord randomDifference(Random &random)
{
    const std::int64_t reach = random.chance(0.5) ? 4 : 40;
    return {random.integer(-reach, reach), random.integer(-reach, reach)};
}

}  // namespace

TEST(TurnBound, isTheCheapestOfAllLegsWhereNothingIsInTheWay)
{
    forEachSeed(3000,
                [](Random &random)
                {
                    const Rings rings(static_cast<int>(random.integer(1, 3)),
                                      random.chance(0.5) ? JumpSet::All : JumpSet::Primitive, randomTurnCosts(random));
                    const HexCoord difference = randomDifference(random);
                    const auto heading =
                        static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(rings.jumps.size())));
                    if (difference == HexCoord{0, 0})
                        EXPECT_EQ(rings.least(difference, heading), 0.0);
                    else
                        EXPECT_NEAR(rings.least(difference, heading), rings.tryAll(difference, heading), 1e-9)
                            << difference.q << ", " << difference.s << ", heading " << heading << ", rings "
                            << rings.rings << ", " << rings.turns.perTurn << " a turn, " << rings.turns.perRadian
                            << " a radian";
                });
}

TEST(TurnBound, noMoveLowersItByMoreThanItCosts)
{
    forEachSeed(300,
                [](Random &random)
                {
                    const Rings rings(static_cast<int>(random.integer(1, 3)), JumpSet::All, randomTurnCosts(random));
                    const TurnBound bound = rings.bound();
                    const HexCoord difference = randomDifference(random);
                    const auto least = [&](HexCoord d, std::size_t heading)
                    {
                        return bound(bound.approach(vectorOf(d), ringNorm(d, rings.rings)), heading);
                    };
                    for (std::size_t k = 0; k < rings.jumps.size(); ++k)
                    {
                        EXPECT_LE(least(difference, rings.jumps.size()), least(difference, k) + 1e-9);
                        EXPECT_LE(least(difference, k),
                                  rings.lengths[k] + least(difference - rings.offsets[k], k) + 1e-9);
                        for (std::size_t j = 0; j < rings.jumps.size(); ++j)
                            EXPECT_LE(least(difference, k), rings.turn(k, j) + least(difference, j) + 1e-9);
                    }
                });
}

TEST(TurnBound, tablesOfAnglesAndTurns)
{
    for (const int r : {1, 2, 3})
    {
        const Rings rings(r, JumpSet::All, {1.5, 0.25});
        const TurnBound bound = rings.bound();
        for (std::size_t a = 0; a < rings.jumps.size(); ++a)
            for (std::size_t b = 0; b < rings.jumps.size(); ++b)
            {
                EXPECT_NEAR(bound.angle(a, b), rings.angle(a, b), 1e-12);
                EXPECT_NEAR(bound.turn(a, b), rings.turn(a, b), 1e-12);
            }
        EXPECT_EQ(bound.turn(0, 0), 0.0);
    }
}
