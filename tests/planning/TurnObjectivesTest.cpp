#include <seahex/planning/RouteFromPath.h>
#include <seahex/planning/TurnAngleObjective.h>
#include <seahex/planning/TurnCountObjective.h>
#include <seahex/route/RouteMetrics.h>

#include "planning/MotionCosts.h"
#include "support/AsciiWorld.h"
#include "support/ExplicitGraph.h"

#include <ompl/util/Exception.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

constexpr double degree = M_PI / 180.0;

/// Open water, poses, and both objectives.
class TurnObjectives : public ::testing::Test
{
protected:
    double angle(const Point &a, double yaw, const Point &b, double otherYaw) const
    {
        return angles.motionCost(stateAt(si, a, yaw).get(), stateAt(si, b, otherYaw).get()).value();
    }
    double count(const Point &a, double yaw, const Point &b, double otherYaw) const
    {
        return counts.motionCost(stateAt(si, a, yaw).get(), stateAt(si, b, otherYaw).get()).value();
    }
    double bound(const Point &a, double yaw, const Point &b, double otherYaw) const
    {
        return angles.motionCostHeuristic(stateAt(si, a, yaw).get(), stateAt(si, b, otherYaw).get()).value();
    }
    /// A path through these places, with yaws, summed up by OMPL.
    og::PathGeometric path(const std::vector<Point> &places, const std::vector<double> &yaws) const
    {
        og::PathGeometric path(si);
        for (std::size_t i = 0; i < places.size(); ++i)
            path.append(stateAt(si, places[i], yaws[i]).get());
        return path;
    }

    const std::shared_ptr<const HexOccupancy> occupancy = occupancyWith(HexLattice(Point(-20, 20), 1.0, 40, 40), {});
    const ob::SpaceInformationPtr si = chartSpace(occupancy, SpaceKind::Pose);
    const TurnAngleObjective angles{si};
    const TurnCountObjective counts{si};
    const std::shared_ptr<TurnAngleObjective> sharedAngles = std::make_shared<TurnAngleObjective>(si);
    const std::shared_ptr<TurnCountObjective> sharedCounts = std::make_shared<TurnCountObjective>(si);
};

TEST_F(TurnObjectives, AMotionTurnsOnDepartureAndOnArrival)
{
    const Point here(0, 0);
    const Point east(5, 0);
    EXPECT_EQ(angle(here, 0.0, east, 0.0), 0.0);
    EXPECT_EQ(count(here, 0.0, east, 0.0), 0.0);
    EXPECT_NEAR(angle(here, 30.0 * degree, east, 0.0), 30.0 * degree, 1e-12);
    EXPECT_EQ(count(here, 30.0 * degree, east, 0.0), 1.0);
    EXPECT_NEAR(angle(here, 0.0, east, -45.0 * degree), 45.0 * degree, 1e-12);
    EXPECT_EQ(count(here, 0.0, east, -45.0 * degree), 1.0);
    EXPECT_NEAR(angle(here, -90.0 * degree, east, 120.0 * degree), 210.0 * degree, 1e-12);
    EXPECT_EQ(count(here, -90.0 * degree, east, 120.0 * degree), 2.0);
    // the smaller way round
    EXPECT_NEAR(angle(east, 170.0 * degree, here, -170.0 * degree), 20.0 * degree, 1e-12);
    // and about at once
    EXPECT_NEAR(angle(here, -180.0 * degree, east, -180.0 * degree), 360.0 * degree, 1e-12);
}

TEST_F(TurnObjectives, OnTheSpotThereIsOneTurn)
{
    const Point here(3, 2);
    EXPECT_EQ(angle(here, 1.0, here, 1.0), 0.0);
    EXPECT_EQ(count(here, 1.0, here, 1.0), 0.0);
    EXPECT_NEAR(angle(here, 170.0 * degree, here, -100.0 * degree), 90.0 * degree, 1e-12);
    EXPECT_EQ(count(here, 170.0 * degree, here, -100.0 * degree), 1.0);
}

TEST_F(TurnObjectives, OnlyWhatTheMetricsCallATurnCounts)
{
    EXPECT_EQ(count({0, 0}, 0.9 * leastTurnRad, {5, 0}, -0.9 * leastTurnRad), 0.0);
    EXPECT_EQ(count({0, 0}, 1.1 * leastTurnRad, {5, 0}, -1.1 * leastTurnRad), 2.0);
}

TEST_F(TurnObjectives, TheWayBackTurnsOtherwise)
{
    EXPECT_FALSE(angles.isSymmetric());
    EXPECT_FALSE(counts.isSymmetric());
    EXPECT_EQ(angle({0, 0}, 0.0, {5, 0}, 0.0), 0.0);
    EXPECT_NEAR(angle({5, 0}, 0.0, {0, 0}, 0.0), 360.0 * degree, 1e-12);
}

TEST_F(TurnObjectives, StatesWithoutHeadingAreRefusedWithAClearSentence)
{
    const auto refuses = [](auto &&make)
    {
        try
        {
            make();
        }
        catch (const ompl::Exception &error)
        {
            return std::string(error.what()).find("have no heading") != std::string::npos;
        }
        return false;
    };
    for (const SpaceKind kind : {SpaceKind::Plane, SpaceKind::Cells})
    {
        const auto without = chartSpace(occupancy, kind);
        EXPECT_TRUE(refuses([&] { TurnAngleObjective objective(without); }));
        EXPECT_TRUE(refuses([&] { TurnCountObjective objective(without); }));
    }
}

TEST_F(TurnObjectives, OnPathsWhoseYawsAreTheirCoursesTheyAreTheMetricsOfTheRoute)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        std::vector<Point> places = {random.pointIn({Point(-15, -15), Point(15, 15)})};
        std::vector<double> yaws = {0.0};
        for (std::int64_t i = random.integer(1, 12); i > 0; --i)
        {
            // half of the steps go on straight, on directions in whole 30 degrees; some stay where they are
            const double course = random.chance(0.5) && yaws.size() > 1
                                      ? yaws.back()
                                      : 30.0 * degree * static_cast<double>(random.integer(-5, 6));
            const double length = random.chance(0.1) ? 0.0 : 0.25 * static_cast<double>(random.integer(1, 8));
            places.push_back(places.back() + length * Point(std::cos(course), std::sin(course)));
            yaws.push_back(length > 0.0 ? course : yaws.back());
        }
        // the first yaw is the first course, so that departing is no turn
        for (std::size_t i = 1; i < places.size() && yaws.size() > 1; ++i)
            if (places[i] != places[0])
            {
                for (std::size_t k = 0; k < i; ++k)
                    yaws[k] = yaws[i];
                break;
            }
        const og::PathGeometric states = path(places, yaws);
        const RouteMetrics metrics = measureRoute(routeFromPath(states), *occupancy, CountedLegs::All);
        EXPECT_NEAR(states.cost(sharedAngles).value(), metrics.turnAngleRad, 1e-9);
        EXPECT_EQ(states.cost(sharedCounts).value(), metrics.turns);
        ASSERT_FALSE(::testing::Test::HasFailure());
    }
}

TEST_F(TurnObjectives, CutWhereTheYawIsTheCourseAMotionCostsTheSame)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const Point a = random.pointIn({Point(-15, -15), Point(15, 15)});
        const Point b = random.pointIn({Point(-15, -15), Point(15, 15)});
        const double yaw = random.real(-3.0, 3.0);
        const double otherYaw = random.real(-3.0, 3.0);
        const double course = std::atan2(b.y() - a.y(), b.x() - a.x());
        const double where = random.real(0.01, 0.99);
        const Point cut = a + where * (b - a);
        EXPECT_NEAR(angle(a, yaw, cut, course) + angle(cut, course, b, otherYaw), angle(a, yaw, b, otherYaw), 1e-9);
        EXPECT_EQ(count(a, yaw, cut, course) + count(cut, course, b, otherYaw), count(a, yaw, b, otherYaw));
        // where SE(2) itself cuts, the yaw is another
        ob::ScopedState<> middle(si);
        si->getStateSpace()->interpolate(stateAt(si, a, yaw).get(), stateAt(si, b, otherYaw).get(), where,
                                         middle.get());
        const double cost = angles.motionCost(stateAt(si, a, yaw).get(), middle.get()).value() +
                            angles.motionCost(middle.get(), stateAt(si, b, otherYaw).get()).value();
        EXPECT_GE(cost, angle(a, yaw, b, otherYaw) - 1e-9);
    }
}

TEST_F(TurnObjectives, WhereNoTurnIsNeededTheBoundIsIdentity)
{
    EXPECT_EQ(bound({0, 0}, 0.0, {5, 0}, 0.0), 0.0);
    EXPECT_EQ(bound({0, 0}, 1.0, {0, 0}, 1.0), 0.0);
    EXPECT_NEAR(bound({0, 0}, 1.0, {5, 0}, -1.0), 2.0, 1e-8);
}

TEST_F(TurnObjectives, NoPathTurnsLessThanTheBound)
{
    // Few legs, and headings from few directions, so that many paths turn as little as they can.
    int tight = 0;
    for (std::uint64_t seed = 1; seed <= 20000; ++seed)
    {
        Random random(seed);
        const auto heading = [&random]
        {
            return random.chance(0.7) ? 45.0 * degree * static_cast<double>(random.integer(-4, 3))
                                      : random.real(-3.14, 3.14);
        };
        std::vector<Point> places;
        std::vector<double> yaws;
        for (std::int64_t i = random.integer(2, 6); i > 0; --i)
        {
            places.emplace_back(static_cast<double>(random.integer(-2, 2)), static_cast<double>(random.integer(-2, 2)));
            yaws.push_back(heading());
        }
        for (std::size_t i = 1; i + 1 < places.size(); ++i)
            if (random.chance(0.6) && places[i] != places[i - 1])
                yaws[i] = std::atan2(places[i].y() - places[i - 1].y(), places[i].x() - places[i - 1].x());
        const double cost = path(places, yaws).cost(sharedAngles).value();
        const double least = bound(places.front(), yaws.front(), places.back(), yaws.back());
        ASSERT_LE(least, cost) << random.seedText();
        ASSERT_GE(least, std::abs(std::remainder(yaws.back() - yaws.front(), 2.0 * M_PI)) - 1e-8)
            << "the difference of the yaws is a weaker bound";
        if (places.size() > 2 && cost < least + 1e-6)
            ++tight;
    }
    EXPECT_GT(tight, 200) << "paths of several legs that turn as little as the bound says";
}

TEST_F(TurnObjectives, TheLeastTurningOnALatticeOfPosesIsTheBoundWhereAStraightMotionIsThere)
{
    // All motions between 5 x 5 places in 8 directions with all 8 headings: Dijkstra's least turning from one pose to
    // every other is never below the bound, and equals it where the places lie in one of the directions.
    constexpr int size = 5;
    constexpr int directions = 8;
    const auto vertex = [](int x, int y, int heading)
    {
        const int number = (y * size + x) * directions + heading;
        return static_cast<std::size_t>(number);
    };
    const auto yawOf = [](int heading)
    {
        return 45.0 * degree * (heading - 4);
    };
    ExplicitGraph graph(static_cast<std::size_t>(size * size * directions));
    const auto forEachPose = [&](auto &&visit)
    {
        for (int x = 0; x < size; ++x)
            for (int y = 0; y < size; ++y)
                for (int heading = 0; heading < directions; ++heading)
                    visit(x, y, heading);
    };
    forEachPose(
        [&](int x, int y, int heading)
        {
            for (int dx = -1; dx <= 1; ++dx)
                for (int dy = -1; dy <= 1; ++dy)
                    for (int next = 0; next < directions; ++next)
                        if (x + dx >= 0 && x + dx < size && y + dy >= 0 && y + dy < size)
                            graph.addEdge(vertex(x, y, heading), vertex(x + dx, y + dy, next),
                                          angle(Point(x, y), yawOf(heading), Point(x + dx, y + dy), yawOf(next)));
        });
    forEachPose(
        [&](int x, int y, int heading)
        {
            if (x > 2 || y > x)
                return;  // the rest is the same turned and mirrored
            const std::vector<double> least = graph.costsFrom({{vertex(x, y, heading), 0.0}});
            forEachPose(
                [&](int toX, int toY, int toHeading)
                {
                    const double cost = least[vertex(toX, toY, toHeading)];
                    const double h = bound(Point(x, y), yawOf(heading), Point(toX, toY), yawOf(toHeading));
                    ASSERT_LE(h, cost);
                    const int dx = std::abs(toX - x);
                    const int dy = std::abs(toY - y);
                    if (dx == 0 || dy == 0 || dx == dy)
                    {
                        ASSERT_NEAR(h, cost, 1e-8);
                    }
                });
        });
}

TEST_F(TurnObjectives, ACountHasNoBoundButIdentity)
{
    // straight there: two turns; by way of a corner: one
    EXPECT_EQ(count({0, 0}, 0.0, {5, 5}, 90.0 * degree), 2.0);
    EXPECT_EQ(path({{0, 0}, {5, 0}, {5, 5}}, {0.0, 0.0, 90.0 * degree}).cost(sharedCounts).value(), 1.0);
    // bends too small to count bring one to any heading
    std::vector<Point> places = {{0, 0}};
    std::vector<double> yaws = {0.0};
    for (int i = 1; i <= 20; ++i)
    {
        yaws.push_back(i * 0.9 * leastTurnRad);
        places.push_back(places.back() + 0.5 * Point(std::cos(yaws.back()), std::sin(yaws.back())));
    }
    EXPECT_EQ(path(places, yaws).cost(sharedCounts).value(), 0.0);
    EXPECT_EQ(counts.motionCostHeuristic(stateAt(si, {0, 0}, 0.0).get(), stateAt(si, {5, 5}, 2.0).get()).value(), 0.0);
}

TEST_F(TurnObjectives, StatesAloneCostNothing)
{
    EXPECT_EQ(angles.stateCost(stateAt(si, {1, 1}, 1.0).get()).value(), 0.0);
    EXPECT_EQ(counts.stateCost(stateAt(si, {1, 1}, 1.0).get()).value(), 0.0);
}

TEST_F(TurnObjectives, TwoThreadsMayAsk)
{
    expectSameFromTwoThreads(angles, occupancy->lattice());
    expectSameFromTwoThreads(counts, occupancy->lattice());
}

}  // namespace
}  // namespace seahex::test
