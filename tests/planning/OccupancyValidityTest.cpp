#include <seahex/planning/OccupancyMotionValidator.h>
#include <seahex/planning/OccupancyValidityChecker.h>

#include "support/AsciiWorld.h"
#include "support/HexOracle.h"
#include "support/PlanningWorlds.h"

#include <ompl/base/spaces/SE2StateSpace.h>

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

struct World
{
    explicit World(std::uint64_t seed) : random(seed)
    {
        const double pitch = random.chance(0.5) ? 1.0 : random.real(0.01, 300.0);
        const Point northWest =
            random.chance(0.5) ? Point(0, 0) : Point(random.real(-1e5, 1e5), random.real(-1e5, 1e5));
        const std::int64_t columns = random.integer(2, 9);
        const HexLattice lattice(northWest, pitch, columns, random.integer(2, 9));
        occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.5));
        si = chartSpace(occupancy, random.chance(0.5) ? SpaceKind::Plane : SpaceKind::Pose);
        const Box box = lattice.bounds();
        tolerance = 1e-9 * std::max({box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff(), pitch});
    }

    ob::ScopedState<> randomState()
    {
        const HexLattice &lattice = occupancy->lattice();
        return stateAt(si, random.pointOf(lattice, random.cellOf(lattice)), random.real(-3.0, 3.0));
    }

    Point at(const ob::ScopedState<> &state) const { return positionOf(si, state.get()); }

    Random random;
    std::shared_ptr<const HexOccupancy> occupancy;
    ob::SpaceInformationPtr si;
    double tolerance;
};

/// True if `answer` is what brute force says; a contact within the tolerance of the exact traversal may be told either
/// way.
bool agrees(bool answer, long double distance, double tolerance)
{
    return distance <= 0 ? !answer : (answer || distance <= tolerance);
}

TEST(OccupancyValidityChecker, EqualsBruteForceOverCells)
{
    int valid = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        World world(seed);
        SCOPED_TRACE(world.random.seedText());
        for (int i = 0; i < 30; ++i)
        {
            const auto state = world.randomState();
            const Point p = world.at(state);
            const bool answer = world.si->isValid(state.get());
            valid += answer ? 1 : 0;
            // corners of cells lie on the bounds, give or take the last digit
            if (world.si->satisfiesBounds(state.get()))
                EXPECT_TRUE(agrees(answer, distanceToBlocked(*world.occupancy, p, p), world.tolerance))
                    << p.transpose();
            else
                EXPECT_FALSE(answer);
        }
    }
    EXPECT_GT(valid, 1000);
    EXPECT_LT(valid, 8000);
}

TEST(OccupancyValidityChecker, ClearanceIsTheSignedDistanceToTheOtherKindOfCell)
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        World world(seed);
        SCOPED_TRACE(world.random.seedText());
        const auto &checker = *world.si->getStateValidityChecker();
        const HexOracle oracle(world.occupancy->lattice());
        for (int i = 0; i < 20; ++i)
        {
            const auto state = world.randomState();
            const Point p = world.at(state);
            double distance = -1.0;
            const bool valid = checker.isValid(state.get(), distance);
            EXPECT_EQ(valid, checker.isValid(state.get()));
            EXPECT_EQ(distance, checker.clearance(state.get()));
            const auto toBlocked = static_cast<double>(distanceToBlocked(*world.occupancy, p, p));
            if (valid)
            {
                EXPECT_NEAR(distance, toBlocked, world.tolerance);
                EXPECT_GT(distance, 0.0);
            }
            else
                EXPECT_LE(distance, world.tolerance);
        }
    }
}

TEST(OccupancyValidityChecker, NothingOutsideTheBoundsIsValid)
{
    const AsciiWorld world(R"(
         . . . . .
        . . . . .
         . . . . .
    )");
    const Point middle = world.lattice().centre(toCube({2, 1}));
    const Box bounds{middle - Point(0.75, 0.75), middle + Point(0.75, 0.75)};
    for (const SpaceKind kind : {SpaceKind::Plane, SpaceKind::Pose})
    {
        const auto si = chartSpace(world.shared(), kind, bounds);
        const auto inside = stateAt(si, middle);
        EXPECT_TRUE(si->isValid(inside.get()));
        EXPECT_TRUE(si->checkMotion(inside.get(), stateAt(si, middle + Point(0.7, 0.0)).get()));
        for (const Point &offset : {Point(0.8, 0.0), Point(-0.8, 0.0), Point(0.0, 0.8), Point(0.0, -0.8), Point(90, 0)})
        {
            const auto outside = stateAt(si, middle + offset);
            EXPECT_FALSE(si->isValid(outside.get())) << offset.transpose();
            EXPECT_FALSE(si->checkMotion(inside.get(), outside.get())) << offset.transpose();
            EXPECT_FALSE(si->checkMotion(outside.get(), inside.get())) << offset.transpose();
        }
        EXPECT_FALSE(si->isValid(stateAt(si, Point(std::nan(""), 0.0)).get()));
    }
    const auto poses = chartSpace(world.shared(), SpaceKind::Pose);
    ob::ScopedState<ob::SE2StateSpace> turned(poses);
    turned->setXY(middle.x(), middle.y());
    turned->setYaw(4.0);
    EXPECT_FALSE(poses->isValid(turned.get())) << "a yaw beyond pi";
}

TEST(OccupancyMotionValidator, EqualsBruteForceOverCellsBothWays)
{
    int valid = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed)
    {
        World world(seed);
        SCOPED_TRACE(world.random.seedText());
        for (int i = 0; i < 20; ++i)
        {
            const auto from = world.randomState();
            const auto to = world.randomState();
            const bool answer = world.si->checkMotion(from.get(), to.get());
            EXPECT_EQ(world.si->checkMotion(to.get(), from.get()), answer);
            std::pair<ob::State *, double> nowhere{nullptr, -1.0};
            EXPECT_EQ(world.si->checkMotion(from.get(), to.get(), nowhere), answer);
            valid += answer ? 1 : 0;
            if (!world.si->satisfiesBounds(from.get()) || !world.si->satisfiesBounds(to.get()))
                EXPECT_FALSE(answer);
            else
                EXPECT_TRUE(
                    agrees(answer, distanceToBlocked(*world.occupancy, world.at(from), world.at(to)), world.tolerance))
                    << world.at(from).transpose() << " to " << world.at(to).transpose();
        }
    }
    EXPECT_GT(valid, 400);
}

TEST(OccupancyMotionValidator, TheMotionToTheLastValidStateIsValidAndNoLongerOneIs)
{
    int asked = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed)
    {
        World world(seed);
        SCOPED_TRACE(world.random.seedText());
        for (int i = 0; i < 20; ++i)
        {
            const auto from = world.randomState();
            auto to = world.randomState();
            ob::ScopedState<> last(world.si);
            std::pair<ob::State *, double> lastValid{last.get(), -1.0};
            if (world.si->checkMotion(from.get(), to.get(), lastValid))
                continue;
            std::pair<ob::State *, double> nowhere{nullptr, -1.0};
            EXPECT_FALSE(world.si->checkMotion(from.get(), to.get(), nowhere));
            EXPECT_EQ(nowhere.second, lastValid.second);
            if (!world.si->isValid(from.get()))
            {
                EXPECT_EQ(lastValid.second, 0.0);
                EXPECT_EQ(world.at(last), world.at(from));
                continue;
            }
            ++asked;
            EXPECT_GE(lastValid.second, 0.0);
            EXPECT_LT(lastValid.second, 1.0);
            EXPECT_TRUE(world.si->isValid(last.get()));
            EXPECT_TRUE(world.si->checkMotion(from.get(), last.get()));
            ob::ScopedState<> farther(world.si);
            const double step = std::max(1e-11, 0.01 * world.tolerance / (world.at(to) - world.at(from)).norm());
            world.si->getStateSpace()->interpolate(from.get(), to.get(), std::min(lastValid.second + step, 1.0),
                                                   farther.get());
            EXPECT_FALSE(world.si->checkMotion(from.get(), farther.get()));
            // what brute force calls free beyond it is no more than the tolerance
            const Point direction = (world.at(to) - world.at(from)).normalized();
            EXPECT_LE(
                distanceToBlocked(*world.occupancy, world.at(from), world.at(last) + 3.0 * world.tolerance * direction),
                world.tolerance);
            // OMPL's random bounce motion has the last valid state written over the end
            std::pair<ob::State *, double> overEnd{to.get(), -1.0};
            EXPECT_FALSE(world.si->checkMotion(from.get(), to.get(), overEnd));
            EXPECT_EQ(overEnd.second, lastValid.second);
            EXPECT_TRUE(world.si->equalStates(to.get(), last.get()));
        }
    }
    EXPECT_GT(asked, 1000);
}

TEST(OccupancyMotionValidator, TheLastValidStateStaysWithinTheBounds)
{
    const AsciiWorld world(R"(
         . . . . . .
        . . . . . .
         . . . . . .
    )");
    const Point west = world.lattice().centre(toCube({1, 1}));
    const Point east = world.lattice().centre(toCube({4, 1}));
    // the water goes on beyond the bounds, which end half way
    const auto si = chartSpace(world.shared(), SpaceKind::Plane, {west - Point(0.5, 0.5), west + Point(1.5, 0.5)});
    ob::ScopedState<> last(si);
    std::pair<ob::State *, double> lastValid{last.get(), -1.0};
    EXPECT_FALSE(si->checkMotion(stateAt(si, west).get(), stateAt(si, east).get(), lastValid));
    EXPECT_NEAR(lastValid.second, 0.5, 1e-9);
    EXPECT_TRUE(si->isValid(last.get()));
    EXPECT_TRUE(si->checkMotion(stateAt(si, west).get(), last.get()));
    lastValid.first = nullptr;
    EXPECT_FALSE(si->checkMotion(stateAt(si, west).get(), stateAt(si, east).get(), lastValid));
    EXPECT_NEAR(lastValid.second, 0.5, 1e-9);
}

TEST(OccupancyMotionValidator, AYawHalfWayOfPiIsNoObstacle)
{
    const AsciiWorld world("A . . . . . . . # B");
    const auto si = chartSpace(world.shared(), SpaceKind::Pose);
    const double yaw = 0.75 * std::acos(-1.0);
    const auto a = stateAt(si, world.centre('A'), yaw);
    ob::ScopedState<> last(si);
    std::pair<ob::State *, double> lastValid{last.get(), -1.0};
    // half way the vessel heads due west, and there is water beyond
    EXPECT_FALSE(si->checkMotion(a.get(), stateAt(si, world.centre('B'), -yaw).get(), lastValid));
    EXPECT_NEAR(lastValid.second, 7.5 / 9.0, 1e-8);
    EXPECT_TRUE(si->checkMotion(a.get(), last.get()));
}

TEST(OccupancyMotionValidator, CountsWhatItAnswered)
{
    const AsciiWorld world("A B # C");
    const auto si = chartSpace(world.shared());
    const auto a = stateAt(si, world.centre('A'));
    const auto b = stateAt(si, world.centre('B'));
    const auto c = stateAt(si, world.centre('C'));
    si->getMotionValidator()->resetMotionCounter();
    EXPECT_TRUE(si->checkMotion(a.get(), b.get()));
    EXPECT_FALSE(si->checkMotion(a.get(), c.get()));
    std::pair<ob::State *, double> lastValid{nullptr, 0.0};
    EXPECT_TRUE(si->checkMotion(b.get(), a.get(), lastValid));
    EXPECT_FALSE(si->checkMotion(b.get(), c.get(), lastValid));
    EXPECT_FALSE(si->checkMotion(c.get(), b.get(), lastValid));
    EXPECT_EQ(si->getMotionValidator()->getValidMotionCount(), 2u);
    EXPECT_EQ(si->getMotionValidator()->getInvalidMotionCount(), 3u);
}

TEST(OccupancyValidity, SeveralThreadsGetTheSameAnswers)
{
    World world(77);
    std::vector<ob::ScopedState<>> states;
    for (int i = 0; i < 60; ++i)
        states.push_back(world.randomState());
    const auto answers = [&]
    {
        std::vector<double> all;
        ob::ScopedState<> last(world.si);
        for (const auto &a : states)
        {
            all.push_back(world.si->isValid(a.get()) ? 1.0 : 0.0);
            all.push_back(world.si->getStateValidityChecker()->clearance(a.get()));
            for (const auto &b : states)
            {
                std::pair<ob::State *, double> lastValid{last.get(), 1.0};
                all.push_back(world.si->checkMotion(a.get(), b.get()) ? 1.0 : 0.0);
                world.si->checkMotion(a.get(), b.get(), lastValid);
                all.push_back(lastValid.second);
            }
        }
        return all;
    };
    const std::vector<double> expected = answers();
    std::atomic<int> equal{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] { equal += answers() == expected ? 1 : 0; });
    for (std::thread &thread : threads)
        thread.join();
    EXPECT_EQ(equal, 4);
}

}  // namespace
}  // namespace seahex::test
