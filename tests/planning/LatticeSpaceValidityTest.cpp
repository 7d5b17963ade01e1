#include <seahex/planning/HexStateSpace.h>
#include <seahex/planning/OccupancyMotionValidator.h>
#include <seahex/planning/OccupancyValidityChecker.h>

#include "support/AsciiWorld.h"
#include "support/HexOracle.h"
#include "support/PlanningWorlds.h"

#include <ompl/base/DiscreteMotionValidator.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

/// An occupancy, and a space of its cells or, as good, of another lattice's.
struct World
{
    World(std::uint64_t seed, bool ownLattice) : random(seed)
    {
        const double pitch = random.chance(0.5) ? 1.0 : random.real(0.01, 300.0);
        const Point corner = random.chance(0.5) ? Point(0, 0) : Point(random.real(-1e5, 1e5), random.real(-1e5, 1e5));
        const std::int64_t columns = random.integer(1, 9);
        const HexLattice cells(corner, pitch, columns, random.integer(1, 9));
        occupancy = randomOccupancy(random, cells, random.real(0.0, 0.4));
        const HexLattice other(corner - pitch * Point(random.real(-1.0, 1.0), random.real(-1.0, 1.0)),
                               pitch * random.real(0.5, 1.6), random.integer(1, 9), random.integer(1, 9));
        space = std::make_shared<HexStateSpace>(ownLattice ? cells : other);
        si = std::make_shared<ob::SpaceInformation>(space);
        si->setStateValidityChecker(std::make_shared<OccupancyValidityChecker>(si, occupancy));
        si->setMotionValidator(std::make_shared<OccupancyMotionValidator>(si, occupancy));
        si->setup();
        const Box box = space->lattice().bounds();
        tolerance = 1e-9 * std::max({box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff(), pitch});
    }

    /// Mostly a cell of the lattice, else one beside it.
    ob::ScopedState<HexStateSpace> randomState()
    {
        ob::ScopedState<HexStateSpace> state(space);
        state->setCell(random.cellOf(space->lattice()) + HexCoord{random.chance(0.05) ? 2 : 0, 0});
        return state;
    }

    Point at(const ob::ScopedState<HexStateSpace> &state) const { return space->lattice().centre(state->cell()); }

    Random random;
    std::shared_ptr<const HexOccupancy> occupancy;
    std::shared_ptr<HexStateSpace> space;
    ob::SpaceInformationPtr si;
    double tolerance;
};

bool agrees(bool answer, long double distance, double tolerance)
{
    return distance <= 0 ? !answer : (answer || distance <= tolerance);
}

TEST(LatticeSpaceValidity, OnItsOwnLatticeACellIsValidIfItIsFree)
{
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
    {
        World world(seed, true);
        SCOPED_TRACE(world.random.seedText());
        forEachCell(world.space->lattice(), 2,
                    [&](HexCoord cell)
                    {
                        ob::ScopedState<HexStateSpace> state(world.space);
                        state->setCell(cell);
                        EXPECT_EQ(world.si->isValid(state.get()), world.occupancy->isFree(cell));
                    });
    }
}

TEST(LatticeSpaceValidity, OnItsOwnLatticeAMotionIsValidIfEveryCellThatItTouchesIsFree)
{
    int valid = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed)
    {
        World world(seed, true);
        SCOPED_TRACE(world.random.seedText());
        for (int i = 0; i < 40; ++i)
        {
            const auto from = world.randomState();
            const auto to = world.randomState();
            bool free = true;
            forEachCell(world.space->lattice(), 3,
                        [&](HexCoord cell)
                        {
                            if (world.occupancy->isBlocked(cell) &&
                                touchesExactly<std::int64_t>(from->cell(), to->cell(), cell))
                                free = false;
                        });
            EXPECT_EQ(world.si->checkMotion(from.get(), to.get()), free);
            valid += free ? 1 : 0;
        }
    }
    EXPECT_GT(valid, 500);
    EXPECT_LT(valid, 5500);
}

TEST(LatticeSpaceValidity, OnAnotherLatticeTheLineBetweenCentresCounts)
{
    int valid = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        World world(seed, false);
        SCOPED_TRACE(world.random.seedText());
        for (int i = 0; i < 20; ++i)
        {
            const auto from = world.randomState();
            const auto to = world.randomState();
            const bool inside = world.space->satisfiesBounds(from.get()) && world.space->satisfiesBounds(to.get());
            const bool answer = world.si->checkMotion(from.get(), to.get());
            EXPECT_EQ(answer, world.si->checkMotion(to.get(), from.get()));
            EXPECT_TRUE(inside || !answer);
            // the oracle looks at the cells around the lattice, not at those far out
            const Box water = world.occupancy->lattice().bounds();
            const long double distance = water.contains(world.at(from)) && water.contains(world.at(to))
                                             ? distanceToBlocked(*world.occupancy, world.at(from), world.at(to))
                                             : 0.0L;
            EXPECT_TRUE(!inside || agrees(answer, distance, world.tolerance));
            valid += answer ? 1 : 0;
            const bool here = world.si->isValid(from.get());
            EXPECT_EQ(here, world.si->checkMotion(from.get(), from.get()));
        }
    }
    EXPECT_GT(valid, 300);
}

/// The cell at a step of the line, if the line up to there touches free cells only and the cell's own line does, too.
bool isReached(const World &world, const ob::ScopedState<HexStateSpace> &from, const ob::ScopedState<HexStateSpace> &to,
               double fraction)
{
    ob::ScopedState<HexStateSpace> state(world.space);
    world.space->interpolate(from.get(), to.get(), fraction, state.get());
    const Point a = world.at(from);
    return world.space->satisfiesBounds(state.get()) &&
           distanceToBlocked(*world.occupancy, a, a + fraction * (world.at(to) - a)) > world.tolerance &&
           distanceToBlocked(*world.occupancy, a, world.at(state)) > world.tolerance;
}

TEST(LatticeSpaceValidity, TheLastValidStateIsTheLastCellThatCanBeReached)
{
    int asked = 0;
    int pulledBack = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        World world(seed, seed % 2 == 0);
        SCOPED_TRACE(world.random.seedText());
        for (int i = 0; i < 25; ++i)
        {
            const auto from = world.randomState();
            auto to = world.randomState();
            ob::ScopedState<HexStateSpace> last(world.space);
            std::pair<ob::State *, double> lastValid{last.get(), -1.0};
            const bool valid = world.si->checkMotion(from.get(), to.get());
            ASSERT_EQ(world.si->checkMotion(from.get(), to.get(), lastValid), valid);
            world.space->setValidSegmentCountFactor(1U + static_cast<unsigned int>(i % 4));
            std::pair<ob::State *, double> nowhere{nullptr, -1.0};
            ASSERT_EQ(world.si->checkMotion(from.get(), to.get(), nowhere), valid);
            if (valid)
                continue;
            EXPECT_EQ(nowhere.second, lastValid.second) << "whatever the factor";
            ob::ScopedState<HexStateSpace> there(world.space);
            world.space->interpolate(from.get(), to.get(), lastValid.second, there.get());
            EXPECT_EQ(there->cell(), last->cell());
            if (!world.si->isValid(from.get()))
            {
                EXPECT_EQ(lastValid.second, 0.0);
                EXPECT_EQ(last->cell(), from->cell());
                continue;
            }
            ++asked;
            EXPECT_TRUE(world.si->isValid(last.get()));
            EXPECT_TRUE(world.si->checkMotion(from.get(), last.get()));
            EXPECT_GT(distanceToBlocked(*world.occupancy, world.at(from), world.at(last)), 0.0L);

            const auto steps = static_cast<double>(hexDistance(from->cell(), to->cell()));
            double step = steps;
            while (step > 0.0 && !isReached(world, from, to, step / steps))
                --step;
            EXPECT_EQ(lastValid.second, step / steps);
            // OMPL's random bounce motion has the last valid state written over the end
            std::pair<ob::State *, double> overEnd{to.get(), -1.0};
            EXPECT_FALSE(world.si->checkMotion(from.get(), to.get(), overEnd));
            EXPECT_EQ(to->cell(), last->cell());
            pulledBack += step > 0.0 ? 1 : 0;
        }
    }
    EXPECT_GT(asked, 1000);
    EXPECT_GT(pulledBack, 100);
}

TEST(LatticeSpaceValidity, HalvesOfAValidMotionMayBeInvalid)
{
    int halves = 0;
    int invalid = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
    {
        World world(seed, true);
        for (int i = 0; i < 40; ++i)
        {
            const auto from = world.randomState();
            const auto to = world.randomState();
            ob::ScopedState<HexStateSpace> middle(world.space);
            world.space->interpolate(from.get(), to.get(), 0.5, middle.get());
            if (!world.si->checkMotion(from.get(), to.get()))
                continue;
            // the cell itself is one that the motion touches
            EXPECT_TRUE(world.si->isValid(middle.get()));
            ++halves;
            invalid += world.si->checkMotion(from.get(), middle.get()) ? 0 : 1;
        }
    }
    EXPECT_GT(halves, 300);
    EXPECT_GT(invalid, 0) << "HexStateSpace.h warns of it";
    EXPECT_LT(invalid, halves / 4);
}

/// How many legs of random bounce motions, on which PRM goes from state to state unchecked, are not valid.
int invalidBounces(const ob::SpaceInformationPtr &si, const ob::MotionValidatorPtr &judge, Random &random)
{
    const auto &space = *si->getStateSpace()->as<HexStateSpace>();
    ob::ScopedState<HexStateSpace> start(si->getStateSpace());
    do
        start->setCell(random.cellOf(space.lattice()));
    while (!si->isValid(start.get()));
    std::vector<ob::State *> states;
    const unsigned int count = si->randomBounceMotion(si->allocStateSampler(), start.get(), 20, states, true);
    int invalid = 0;
    const ob::State *last = start.get();
    for (unsigned int i = 0; i < count; ++i)
    {
        invalid += judge->checkMotion(last, states[i]) ? 0 : 1;
        last = states[i];
    }
    si->freeStates(states);
    return invalid;
}

TEST(LatticeSpaceValidity, RandomBouncesHoldWithThisValidatorAndNotWithOmpls)
{
    Random random(3);
    int wrongWithOmpls = 0;
    for (int i = 0; i < 100; ++i)
    {
        const auto occupancy = randomOccupancy(random, HexLattice(Point(0, 0), 1.0, 14, 14), 0.25);
        const auto si = std::make_shared<ob::SpaceInformation>(std::make_shared<HexStateSpace>(occupancy->lattice()));
        si->setStateValidityChecker(std::make_shared<OccupancyValidityChecker>(si, occupancy));
        const auto exact = std::make_shared<OccupancyMotionValidator>(si, occupancy);
        si->setMotionValidator(exact);
        si->setup();
        EXPECT_EQ(invalidBounces(si, exact, random), 0);
        // judged by itself, not by the exact one
        const auto sampled = std::make_shared<ob::DiscreteMotionValidator>(si);
        si->setMotionValidator(sampled);
        wrongWithOmpls += invalidBounces(si, sampled, random);
    }
    EXPECT_GT(wrongWithOmpls, 0) << "HexStateSpace.h warns of it";
}

}  // namespace
}  // namespace seahex::test
