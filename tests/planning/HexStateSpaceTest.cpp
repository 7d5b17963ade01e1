#include <seahex/planning/HexStateSpace.h>

#include "planning/HexStates.h"
#include "support/HexOracle.h"
#include "support/Random.h"

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateStorage.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/samplers/informed/PathLengthDirectInfSampler.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

TEST(HexStateSpace, EnforcesRowAndColumn)
{
    const auto space = spaceOf(5, 4);
    forEachCell(space->lattice(), 3,
                [&](HexCoord cell)
                {
                    auto state = stateOf(space, cell);
                    EXPECT_EQ(space->satisfiesBounds(state.get()), space->lattice().contains(cell));
                    space->enforceBounds(state.get());
                    const OffsetCoord before = toOffset(cell);
                    const OffsetCoord after = toOffset(state->cell());
                    EXPECT_EQ(after.column, before.column < 0 ? 0 : before.column > 4 ? 4 : before.column);
                    EXPECT_EQ(after.row, before.row < 0 ? 0 : before.row > 3 ? 3 : before.row);
                });
}

TEST(HexStateSpace, SamplesAboutAnyStateAndAnyDistance)
{
    const auto space = spaceOf(6, 7, 2.0, Point(10, -3));
    const ob::StateSamplerPtr sampler = space->allocDefaultStateSampler();
    const auto centre = stateOf(space, toCube({2, 3}));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    int cells[7][6] = {};
    for (int i = 0; i < 4000; ++i)
    {
        auto state = stateOf(space, HexCoord{});
        sampler->sampleUniformNear(state.get(), centre.get(), infinity);
        const OffsetCoord drawn = toOffset(state->cell());
        ASSERT_TRUE(space->satisfiesBounds(state.get()));
        ++cells[drawn.row][drawn.column];

        for (const double none : {0.0, -1.0, 1.999, std::nan("")})
        {
            sampler->sampleUniformNear(state.get(), centre.get(), none);
            ASSERT_EQ(state->cell(), centre->cell()) << none;
        }
        // over the state itself, and about one that is out of bounds
        space->copyState(state.get(), centre.get());
        sampler->sampleUniformNear(state.get(), state.get(), 2.0);
        ASSERT_LE(space->distance(state.get(), centre.get()), 2.0 * (1.0 + 1e-12));
        const auto out = stateOf(space, toCube({-40, 3}));
        sampler->sampleUniformNear(state.get(), out.get(), 0.0);
        ASSERT_EQ(state->cell(), toCube({0, 3}));
        sampler->sampleGaussian(state.get(), out.get(), 0.0);
        ASSERT_EQ(state->cell(), toCube({0, 3}));
        sampler->sampleGaussian(state.get(), centre.get(), 1e300);
        ASSERT_TRUE(space->satisfiesBounds(state.get()));
    }
    for (const auto &row : cells)
        for (const int count : row)
            EXPECT_GT(count, 20);
}

TEST(HexStateSpace, ManyColumnsAreAllDrawn)
{
    // more than an int counts
    const auto space = spaceOf(std::int64_t{1} << 36, 1);
    const ob::StateSamplerPtr sampler = space->allocDefaultStateSampler();
    int half[2] = {};
    for (int i = 0; i < 400; ++i)
    {
        CellState state(space);
        sampler->sampleUniform(state.get());
        ASSERT_TRUE(space->satisfiesBounds(state.get()));
        ++half[toOffset(state->cell()).column >> 35];
    }
    EXPECT_GT(half[0], 100);
    EXPECT_GT(half[1], 100);
}

TEST(HexStateSpace, RealsAreTheCentreAndBackTheCellOfAnyPoint)
{
    Random random(8);
    for (int i = 0; i < 300; ++i)
    {
        const auto space = spaceOf(random.integer(1, 3000000), random.integer(1, 3000000), random.real(1e-3, 400.0),
                                   Point(random.real(-1e6, 1e6), random.real(-1e6, 1e6)));
        const auto state = stateOf(space, random.cellOf(space->lattice()));
        std::vector<double> reals;
        space->copyToReals(reals, state.get());
        EXPECT_EQ(reals.size(), 2U);
        EXPECT_EQ(Point(reals[0], reals[1]), space->lattice().centre(state->cell()));
        CellState again(space);
        space->copyFromReals(again.get(), reals);
        EXPECT_EQ(again->cell(), state->cell());
        const Point p = random.pointOf(space->lattice(), state->cell());
        space->copyFromReals(again.get(), {p.x(), p.y()});
        EXPECT_EQ(again->cell(), space->lattice().cellAt(p));
    }
    const auto space = spaceOf(3, 3);
    CellState state(space);
    for (const std::vector<double> &out : {std::vector<double>{-5.0, -1.0}, {1e300, 0.0}, {std::nan(""), 0.0}})
    {
        space->copyFromReals(state.get(), out);
        EXPECT_FALSE(space->satisfiesBounds(state.get())) << out[0] << ", " << out[1];
    }
    EXPECT_THROW(space->copyFromReals(state.get(), {1.0}), ompl::Exception);
    EXPECT_THROW(space->copyFromReals(state.get(), {1.0, 2.0, 3.0}), ompl::Exception);
}

TEST(HexStateSpace, HoldsNoDoubles)
{
    const auto space = spaceOf(3, 3);
    space->setup();
    CellState state(space);
    EXPECT_EQ(state->cell(), toCube({0, 0}));
    EXPECT_EQ(space->getValueAddressAtIndex(state.get(), 0), nullptr);
    EXPECT_TRUE(space->getValueLocations().empty());
    EXPECT_THROW(state[0] = 1.0, ompl::Exception);
}

TEST(HexStateSpace, RefusesLatticesWhoseCentresCannotBeToldApart)
{
    EXPECT_THROW(spaceOf(3, 3, 1.0, Point(2e12, 0)), ompl::Exception);
    EXPECT_THROW(spaceOf(3, 3, 1e-6, Point(0, -2e6)), ompl::Exception);
    EXPECT_THROW(spaceOf(std::int64_t{1} << 41, 1), ompl::Exception);
    EXPECT_NO_THROW(spaceOf(3, 3, 1.0, Point(1e12, -1e12)));
}

TEST(HexStateSpace, PassesItsSanityChecksInPrint)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    for (const auto &[columns, rows] : {std::pair{1, 1}, {1, 5}, {30, 20}})
    {
        ob::SpaceInformation si(spaceOf(columns, rows, 250.0, Point(5e5, 2e6)));
        si.setStateValidityChecker([](const ob::State *) { return true; });
        si.setup();
        std::ostringstream properties;
        si.printProperties(properties);
        EXPECT_NE(properties.str().find("sanity checks for state space passed"), std::string::npos) << properties.str();
        std::ostringstream settings;
        si.printSettings(settings);
        EXPECT_NE(settings.str().find(std::to_string(columns) + " x " + std::to_string(rows) + " cells, pitch 250"),
                  std::string::npos)
            << settings.str();
    }
}

TEST(HexStateSpace, ProjectsCentresOnAGridNoFinerThanItself)
{
    const auto few = spaceOf(5, 1, 2.0);
    few->setup();
    EXPECT_EQ(few->getDefaultProjection()->getCellSizes(), (std::vector<double>{2.0, 2.0}));

    const auto many = spaceOf(200, 300, 2.0, Point(7, 9));
    many->setup();
    const auto projection = many->getDefaultProjection();
    const Box box = many->lattice().bounds();
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
        EXPECT_DOUBLE_EQ(projection->getCellSizes(axis), (box.max[axis] - box.min[axis]) / 20.0);
        EXPECT_EQ(projection->getBounds().low[axis], box.min[axis]);
        EXPECT_EQ(projection->getBounds().high[axis], box.max[axis]);
    }
    Eigen::VectorXd point(2);
    projection->project(stateOf(many, toCube({11, 12})).get(), point);
    EXPECT_EQ(Point(point), many->lattice().centre(toCube({11, 12})));
}

TEST(HexStateSpace, PrintsACell)
{
    const auto space = spaceOf(5, 5, 2.0);
    std::ostringstream text;
    space->printState(stateOf(space, toCube({3, 0})).get(), text);
    const double y = -2.0 / std::sqrt(3.0);
    std::ostringstream expected;
    expected << "HexState [column 3, row 0, centre 8 " << y << "]\n";
    EXPECT_EQ(text.str(), expected.str());
}

TEST(HexStateSpace, StoredStatesAreReadByTheSameLatticeOnly)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const auto space = spaceOf(6, 6);
    ob::StateStorage stored(space);
    stored.generateSamples(20);
    std::stringstream file;
    stored.store(file);
    const std::string bytes = file.str();
    const auto statesReadBy = [&bytes](const ob::StateSpacePtr &reader)
    {
        std::istringstream in(bytes);
        ob::StateStorage storage(reader);
        storage.load(in);
        return storage.size();
    };
    EXPECT_EQ(statesReadBy(spaceOf(6, 6)), 20U);
    EXPECT_EQ(statesReadBy(spaceOf(6, 7)), 0U);
    EXPECT_EQ(statesReadBy(spaceOf(6, 6, 1.5)), 0U);
    EXPECT_EQ(statesReadBy(spaceOf(6, 6, 1.0, Point(0, 1))), 0U);
    EXPECT_EQ(statesReadBy(spaceOf(6, 6, 1.0, Point(-0.0, 0))), 20U) << "-0 is 0";
}

/// The informed sampler of path length between two cells of a row.
ob::InformedSamplerPtr informedSampler(const std::shared_ptr<HexStateSpace> &space, HexCoord start, HexCoord goal)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    si->setStateValidityChecker([](const ob::State *) { return true; });
    si->setup();
    const auto problem = std::make_shared<ob::ProblemDefinition>(si);
    problem->setStartAndGoalStates(stateOf(space, start), stateOf(space, goal));
    problem->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si));
    return std::make_shared<ob::PathLengthDirectInfSampler>(problem, 100);
}

/// The space with a type of its own, as OMPL's guide asks for.
struct TypedSpace : HexStateSpace
{
    explicit TypedSpace(const HexLattice &lattice) : HexStateSpace(lattice) { type_ = 1000; }
};

TEST(HexStateSpace, IsOfUnknownTypeForTheInformedSampler)
{
    const HexLattice lattice(Point(50, 20), 2.0, 40, 40);
    const HexCoord start = toCube({5, 20});
    const HexCoord goal = toCube({35, 20});
    EXPECT_THROW(informedSampler(std::make_shared<TypedSpace>(lattice), start, goal), ompl::Exception);

    const auto space = std::make_shared<HexStateSpace>(lattice);
    EXPECT_EQ(space->getType(), ob::STATE_SPACE_UNKNOWN);
    const auto informed = informedSampler(space, start, goal);
    for (int i = 0; i < 500; ++i)
    {
        CellState state(space);
        ASSERT_TRUE(informed->sampleUniform(state.get(), ob::Cost(66.0)));
        EXPECT_TRUE(space->satisfiesBounds(state.get()));
        const double by = space->distance(stateOf(space, start).get(), state.get()) +
                          space->distance(state.get(), stateOf(space, goal).get());
        EXPECT_LE(by, 66.0 + 4.0 / std::sqrt(3.0)) << "a cell of the ellipse";
    }
}

TEST(HexStateSpace, TheInformedSamplerFindsCellsOnTheVeryLine)
{
    // BIT* asks for states that no path of less than the distance between start and goal leads over
    for (const Point &corner : {Point(0, 0), Point(-3e5, 4e5), Point(1234567.8, 0.1)})
        for (const double pitch : {1.0, 2.7, 250.0})
            for (const HexCoord step :
                 {HexCoord{1, 0}, HexCoord{0, 1}, HexCoord{-1, 2}, HexCoord{1, 1}, HexCoord{2, 1}})
            {
                const auto space = spaceOf(20, 20, pitch, corner);
                const HexCoord start = toCube({4, 2});
                const HexCoord goal = start + 6 * step;
                const ob::Cost least(space->distance(stateOf(space, start).get(), stateOf(space, goal).get()));
                const auto informed = informedSampler(space, start, goal);
                std::set<HexCoord> drawn;
                for (int i = 0; i < 6000; ++i)
                {
                    CellState state(space);
                    ASSERT_TRUE(informed->sampleUniform(state.get(), least, ob::Cost(1e300)));
                    drawn.insert(state->cell());
                }
                for (int k = 0; k <= 6; ++k)
                    EXPECT_EQ(drawn.count(start + k * step), 1U) << k << " steps of " << step.q << ", " << step.s
                                                                 << "; " << pitch << " at " << corner.transpose();
            }
}

}  // namespace
}  // namespace seahex::test
