#include <seahex/planning/DiveSetup.h>
#include <seahex/planning/DiveStates.h>
#include <seahex/planning/SeabedMotionValidator.h>
#include <seahex/planning/SeabedValidityChecker.h>

#include "support/Seabeds.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

struct Dive
{
    explicit Dive(std::uint64_t seed)
        : random(seed), arena(std::make_shared<const DiveArena>(
                            randomSeabed(random, 14, 10, random.chance(0.5) ? 0.0 : 0.03), DiveLimits{3.0, 1.0})),
          setup(diveSpace(*arena))
    {
        useDiveArena(setup, arena);
        setup.getSpaceInformation()->setup();
    }

    ob::ScopedState<> at(const Point3 &p) const
    {
        ob::ScopedState<> state(setup.getStateSpace());
        placeInWater(state.get(), p);
        return state;
    }

    Random random;
    std::shared_ptr<const DiveArena> arena;
    og::SimpleSetup setup;
};

TEST(DiveSpace, isTheArenasBoxInMetres)
{
    const Dive dive(1);
    const auto &space = dive.setup.getStateSpace();
    EXPECT_EQ(space->getDimension(), 3u);
    const Point3 extent = dive.arena->highest() - dive.arena->lowest();
    EXPECT_NEAR(space->getMeasure(), extent.prod(), 1e-6 * extent.prod());
    EXPECT_NEAR(space->getMaximumExtent(), extent.norm(), 1e-6);
    EXPECT_EQ(positionInWater(dive.at(Point3(1, 2, 3)).get()), Point3(1, 2, 3));
    EXPECT_TRUE(dive.setup.getProblemDefinition()->hasOptimizationObjective());
}

TEST(SeabedValidityChecker, isTheArenaWithinTheBounds)
{
    int valid = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
    {
        Dive dive(seed);
        SCOPED_TRACE(dive.random.seedText());
        const auto &checker = *dive.setup.getStateValidityChecker();
        for (int i = 0; i < 50; ++i)
        {
            const Point3 p = anyPosition(dive.random, *dive.arena);
            double distance = -1.0;
            EXPECT_EQ(checker.isValid(dive.at(p).get()), dive.arena->isFree(p));
            EXPECT_EQ(checker.isValid(dive.at(p).get(), distance), dive.arena->isFree(p));
            EXPECT_EQ(distance, dive.arena->room(p));
            EXPECT_EQ(checker.clearance(dive.at(p).get()), distance);
            valid += dive.arena->isFree(p) ? 1 : 0;
        }
        for (int axis = 0; axis < 3; ++axis)
        {
            Point3 outside = freePosition(dive.random, *dive.arena);
            outside[axis] = dive.arena->highest()[axis] + 1.0;
            EXPECT_FALSE(checker.isValid(dive.at(outside).get()));
            outside[axis] = dive.arena->lowest()[axis] - 1.0;
            EXPECT_FALSE(checker.isValid(dive.at(outside).get()));
            outside[axis] = std::nan("");
            EXPECT_FALSE(checker.isValid(dive.at(outside).get()));
        }
    }
    EXPECT_GT(valid, 300);
    EXPECT_LT(valid, 1700);
}

TEST(SeabedValidityChecker, asksForTheSpacesBoundsToo)
{
    Dive dive(2);
    const Point3 p = freePosition(dive.random, *dive.arena);
    const Point3 q = freePosition(dive.random, *dive.arena);
    ob::RealVectorBounds bounds(3);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
        bounds.setLow(axis, p[axis] - 0.001);
        bounds.setHigh(axis, p[axis] + 0.001);
    }
    dive.setup.getStateSpace()->as<ob::RealVectorStateSpace>()->setBounds(bounds);
    const auto &si = dive.setup.getSpaceInformation();
    EXPECT_TRUE(si->isValid(dive.at(p).get()));
    EXPECT_FALSE(si->isValid(dive.at(q).get()));
    EXPECT_FALSE(si->checkMotion(dive.at(p).get(), dive.at(q).get()));
    EXPECT_FALSE(si->checkMotion(dive.at(q).get(), dive.at(p).get()));
}

TEST(SeabedMotionValidator, bothFormsAgreeAndTheLastValidStateHolds)
{
    int valid = 0;
    int invalid = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
    {
        Dive dive(seed);
        SCOPED_TRACE(dive.random.seedText());
        const auto &si = *dive.setup.getSpaceInformation();
        const auto validator = si.getMotionValidator();
        for (int i = 0; i < 20; ++i)
        {
            const Point3 a = dive.random.chance(0.9) ? freePosition(dive.random, *dive.arena)
                                                     : anyPosition(dive.random, *dive.arena);
            const Point3 b = anyPosition(dive.random, *dive.arena);
            const auto from = dive.at(a);
            auto to = dive.at(b);
            const bool free = dive.arena->isFree(a, b);
            EXPECT_EQ(validator->checkMotion(from.get(), to.get()), free);
            EXPECT_EQ(validator->checkMotion(to.get(), from.get()), free) << "backwards";
            std::pair<ob::State *, double> last(nullptr, -1.0);
            EXPECT_EQ(validator->checkMotion(from.get(), to.get(), last), free) << "no state wanted";
            last.first = to.get();  // written over the end, as planners do
            EXPECT_EQ(validator->checkMotion(from.get(), to.get(), last), free);
            (free ? valid : invalid) += 1;
            if (free)
                continue;
            ASSERT_GE(last.second, 0.0);
            ASSERT_LT(last.second, 1.0);
            const Point3 end = positionInWater(to.get());
            EXPECT_LE((end - (a + last.second * (b - a))).norm(), 1e-9 * (1.0 + a.norm() + b.norm()));
            if (!si.isValid(from.get()))
            {
                EXPECT_EQ(last.second, 0.0);
                EXPECT_EQ(end, a);
                continue;
            }
            EXPECT_TRUE(si.isValid(to.get()));
            EXPECT_TRUE(si.checkMotion(from.get(), to.get()));
            const Point3 beyond = a + std::min(1.0, last.second + 1e-9) * (b - a);
            EXPECT_FALSE(dive.arena->isFree(a, beyond)) << "not the largest fraction";
        }
    }
    EXPECT_GT(valid, 100);
    EXPECT_GT(invalid, 400);
}

TEST(SeabedMotionValidator, countsWhatItJudged)
{
    Dive dive(3);
    const auto validator = dive.setup.getSpaceInformation()->getMotionValidator();
    validator->resetMotionCounter();
    const Point3 p = freePosition(dive.random, *dive.arena);
    const Point3 above(p.x(), p.y(), dive.arena->lowest().z() - 1.0);
    std::pair<ob::State *, double> last(nullptr, 0.0);
    validator->checkMotion(dive.at(p).get(), dive.at(p).get());
    validator->checkMotion(dive.at(p).get(), dive.at(above).get());
    validator->checkMotion(dive.at(p).get(), dive.at(above).get(), last);
    EXPECT_EQ(validator->getValidMotionCount(), 1u);
    EXPECT_EQ(validator->getInvalidMotionCount(), 2u);
}

TEST(SeabedValidity, otherSpacesAreRefused)
{
    Dive dive(4);
    const auto bounded = [](unsigned int dimension)
    {
        auto space = std::make_shared<ob::RealVectorStateSpace>(dimension);
        space->setBounds(0.0, 1.0);
        return space;
    };
    for (const ob::StateSpacePtr &space : {ob::StateSpacePtr(bounded(2)), ob::StateSpacePtr(bounded(4)),
                                           ob::StateSpacePtr(std::make_shared<ob::SE2StateSpace>()),
                                           ob::StateSpacePtr(std::make_shared<ob::SE3StateSpace>())})
    {
        og::SimpleSetup setup(space);
        const auto &si = setup.getSpaceInformation();
        EXPECT_THROW(useDiveArena(setup, dive.arena), ompl::Exception);
        EXPECT_THROW(SeabedValidityChecker(si, dive.arena), ompl::Exception);
        EXPECT_THROW(SeabedMotionValidator(si, dive.arena), ompl::Exception);
        EXPECT_THROW(setStartAndGoal(setup, Point3(0, 0, 1), Point3(1, 1, 1)), ompl::Exception);
    }
}

}  // namespace
}  // namespace seahex::test
