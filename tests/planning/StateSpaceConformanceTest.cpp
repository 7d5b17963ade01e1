#include "support/StateSpaceConformance.h"

#include "planning/DefectiveSpaces.h"
#include "support/HexOracle.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

constexpr double pi = 3.14159265358979323846;

double euclidean(const Reals &a, const Reals &b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1]);
}

Reals centreOf(const HexOracle &oracle, HexCoord cell)
{
    const HexOracle::Vector centre = oracle.centre(cell);
    return {static_cast<double>(centre.x), static_cast<double>(centre.y)};
}

/// What is known by brute force of a space of the lattice.
template <class Space>
SpacePromises promisesOf(const HexLattice &lattice)
{
    const HexOracle oracle(lattice);
    SpacePromises promises;
    promises.distance = euclidean;
    forEachCell(lattice, 2,
                [&](HexCoord cell)
                {
                    const bool inside = lattice.contains(cell);
                    (inside ? promises.everyState : promises.outside).push_back(centreOf(oracle, cell));
                });
    for (const Reals &a : promises.everyState)
        for (const Reals &b : promises.everyState)
            promises.extent = std::max(promises.extent, euclidean(a, b));
    if (promises.everyState.size() == 1)
        promises.extent = lattice.pitch();
    promises.measure =
        static_cast<double>(promises.everyState.size()) * lattice.pitch() * lattice.pitch() * std::sqrt(0.75);
    promises.rounding = 1e-9 * (lattice.pitch() + promises.extent) + 1e-15 * lattice.northWest().cwiseAbs().maxCoeff();
    promises.interpolationError = lattice.pitch() / std::sqrt(3.0);
    promises.sanityFlags = ob::StateSpace::STATESPACE_DISTANCE_DIFFERENT_STATES |
                           ob::StateSpace::STATESPACE_DISTANCE_SYMMETRIC | ob::StateSpace::STATESPACE_DISTANCE_BOUND |
                           ob::StateSpace::STATESPACE_RESPECT_BOUNDS | ob::StateSpace::STATESPACE_ENFORCE_BOUNDS_NO_OP |
                           ob::StateSpace::STATESPACE_SERIALIZATION;
    const std::int64_t least = std::min(lattice.columns(), lattice.rows());
    if (least >= 25)
        promises.gaussian = {centreOf(oracle, toCube({lattice.columns() / 2, lattice.rows() / 2})),
                             0.06 * static_cast<double>(least) * lattice.pitch()};
    const Point &corner = lattice.northWest();
    for (const HexLattice &other :
         {HexLattice(corner, lattice.pitch(), lattice.columns() + 1, lattice.rows()),
          HexLattice(corner, lattice.pitch(), lattice.columns(), lattice.rows() + 1),
          HexLattice(corner, lattice.pitch() * (1.0 + 1e-15), lattice.columns(), lattice.rows()),
          HexLattice(corner + Point(0.1, 0.0), lattice.pitch(), lattice.columns(), lattice.rows()),
          HexLattice(corner - Point(0.0, 0.1), lattice.pitch(), lattice.columns(), lattice.rows())})
        promises.others.push_back(std::make_shared<Space>(other));
    promises.others.push_back(std::make_shared<ob::RealVectorStateSpace>(2));
    return promises;
}

template <class Space>
SpaceFactory factoryOf(const HexLattice &lattice)
{
    return [lattice]
    {
        return std::make_shared<CountedStates<Space>>(lattice);
    };
}

std::string textOf(const std::vector<std::string> &lines)
{
    std::string text;
    for (const std::string &line : lines)
        text += "\n  " + line;
    return text;
}

void expectConforms(const SpaceFactory &makeSpace, const SpacePromises &promises, std::uint64_t seed)
{
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<std::string> failures = conformanceFailures(makeSpace, promises, seed);
    EXPECT_TRUE(failures.empty()) << textOf(failures);
}

TEST(StateSpaceConformance, LatticesOfEveryShapeConform)
{
    std::uint64_t seed = 1;
    for (const auto &[columns, rows] :
         {std::pair{1, 1}, {1, 2}, {1, 9}, {9, 1}, {2, 2}, {2, 9}, {5, 4}, {4, 5}, {7, 7}})
        for (const auto &[pitch, corner] :
             {std::pair{1.0, Point(0, 0)}, {250.0, Point(-3e6, 4e6)}, {0.002, Point(112.5, 21.7)}})
        {
            const HexLattice lattice(corner, pitch, columns, rows);
            SCOPED_TRACE(std::to_string(columns) + " x " + std::to_string(rows) + ", pitch " + std::to_string(pitch));
            expectConforms(factoryOf<HexStateSpace>(lattice), promisesOf<HexStateSpace>(lattice), seed++);
        }
}

TEST(StateSpaceConformance, ALargerLatticeConforms)
{
    const HexLattice lattice(Point(40.0, 30.0), 2.0, 26, 29);
    expectConforms(factoryOf<HexStateSpace>(lattice), promisesOf<HexStateSpace>(lattice), 77);
}

TEST(StateSpaceConformance, ThePlaneConforms)
{
    SpacePromises promises;
    promises.measure = 12.0 * 5.0;
    promises.extent = 13.0;
    promises.distance = euclidean;
    promises.state = [](Random &random) -> Reals
    {
        const double x = random.real(-2.0, 10.0);
        return {x, random.real(1.0, 6.0)};
    };
    promises.outside = {{-2.1, 3.0}, {10.1, 3.0}, {0.0, 0.9}, {0.0, 6.1}, {1e9, -1e9}};
    promises.nearReach = std::sqrt(2.0);  // a square
    promises.gaussian = {{4.0, 3.5}, 0.4};
    promises.projects = false;  // OMPL 1.5.2 aborts with assertions on
    promises.others = {std::make_shared<ob::RealVectorStateSpace>(3)};
    const auto makeSpace = []
    {
        auto space = std::make_shared<CountedStates<ob::RealVectorStateSpace>>(2U);
        ob::RealVectorBounds bounds(2);
        bounds.low = {-2.0, 1.0};
        bounds.high = {10.0, 6.0};
        space->setBounds(bounds);
        return space;
    };
    expectConforms(makeSpace, promises, 5);
}

TEST(StateSpaceConformance, PosesConform)
{
    SpacePromises promises;
    promises.measure = 60.0 * 0.5 * 2.0 * pi;
    promises.extent = 13.0 + 0.5 * pi;
    promises.distance = [](const Reals &a, const Reals &b)
    {
        return euclidean(a, b) + 0.5 * std::abs(std::remainder(a[2] - b[2], 2.0 * pi));
    };
    promises.state = [](Random &random) -> Reals
    {
        const double x = random.real(-2.0, 10.0);
        const double y = random.real(1.0, 6.0);
        return {x, y, random.real(-3.1, 3.1)};
    };
    promises.outside = {{-2.1, 3.0, 0.0}, {0.0, 6.1, 0.0}, {0.0, 3.0, 3.2}, {1e9, -1e9, 1e3}};
    promises.nearReach = 3.0;
    promises.countsFactor = false;  // OMPL's compound spaces ignore their own
    const auto makeSpace = []
    {
        auto space = std::make_shared<CountedStates<ob::SE2StateSpace>>();
        ob::RealVectorBounds bounds(2);
        bounds.low = {-2.0, 1.0};
        bounds.high = {10.0, 6.0};
        space->setBounds(bounds);
        return space;
    };
    expectConforms(makeSpace, promises, 6);
}

/// A space with a defect, and the rule that it breaks, perhaps among others.
struct Defect
{
    std::string name;
    std::string rule;
    SpaceFactory makeSpace;
    SpacePromises promises;
};

const HexLattice small(Point(3.0, 8.0), 2.0, 7, 8);
const HexLattice large(Point(3.0, 8.0), 2.0, 25, 26);

template <class Space>
Defect defect(const std::string &name, const std::string &rule)
{
    // a spread is only seen where there is room for it
    const HexLattice &lattice = rule == "gaussian sampler" ? large : small;
    Defect made{name, rule, {}, promisesOf<Space>(lattice)};
    made.makeSpace = factoryOf<Space>(lattice);
    return made;
}

std::vector<Defect> allDefects()
{
    using namespace defects;
    return {defect<CopiesNothing>("CopiesNothing", "copies"),
            defect<EqualInOneRow>("EqualInOneRow", "distance"),
            defect<CountsSteps>("CountsSteps", "distance"),
            defect<EastIsFarther>("EastIsFarther", "distance"),
            defect<SquaresDistances>("SquaresDistances", "metric"),
            defect<ExtentOfTheBounds>("ExtentOfTheBounds", "extent"),
            defect<ExtentOfOneRow>("ExtentOfOneRow", "extent"),
            defect<MeasureInCells>("MeasureInCells", "measure"),
            defect<Unbounded>("Unbounded", "bounds"),
            defect<EnforcesColumnsOnly>("EnforcesColumnsOnly", "bounds"),
            defect<EnforcesACorner>("EnforcesACorner", "bounds"),
            defect<RoundsPoints>("RoundsPoints", "interpolation symmetry"),
            defect<LeavesToTheWest>("LeavesToTheWest", "interpolation bounds"),
            defect<NeverArrives>("NeverArrives", "interpolation ends"),
            defect<JumpsHalfWay>("JumpsHalfWay", "interpolation line"),
            defect<WritesBeforeItReads>("WritesBeforeItReads", "interpolation overlap"),
            defect<NoSegmentBetweenNeighbours>("NoSegmentBetweenNeighbours", "segments"),
            defect<IgnoresTheFactor>("IgnoresTheFactor", "segments"),
            defect<NotSerialised>("NotSerialised", "serialisation"),
            defect<SerialisesTheRowOnly>("SerialisesTheRowOnly", "serialisation"),
            defect<SerialisesTooMuch>("SerialisesTooMuch", "serialisation"),
            defect<OneReal>("OneReal", "reals"),
            defect<RealsOfTheNextCell>("RealsOfTheNextCell", "reals"),
            defect<SignatureOfAnyLattice>("SignatureOfAnyLattice", "signature"),
            defect<SignatureWithoutLength>("SignatureWithoutLength", "signature"),
            defect<NoProjection>("NoProjection", "projection"),
            defect<ProjectionForgetsTheUser>("ProjectionForgetsTheUser", "projection"),
            defect<MoreWithEverySetup>("MoreWithEverySetup", "setup"),
            defect<InsaneByItsOwnAccount>("InsaneByItsOwnAccount", "sanity checks"),
            defect<PrintsNothing>("PrintsNothing", "printing"),
            defect<OneNameForAll>("OneNameForAll", "names"),
            defect<Throws>("Throws", "exceptions"),
            defect<KeepsAState>("KeepsAState", "states"),
            defect<SampledBy<NeverTheLastColumn>>("SampledBy<NeverTheLastColumn>", "uniform sampler"),
            defect<SampledBy<LikesTheFirstCell>>("SampledBy<LikesTheFirstCell>", "uniform sampler"),
            defect<SampledBy<NearOutOfBounds>>("SampledBy<NearOutOfBounds>", "near sampler"),
            defect<SampledBy<NearInASquare>>("SampledBy<NearInASquare>", "near sampler"),
            defect<SampledBy<NearIsTheCentre>>("SampledBy<NearIsTheCentre>", "near sampler"),
            defect<SampledBy<GaussianOutOfBounds>>("SampledBy<GaussianOutOfBounds>", "gaussian sampler"),
            defect<SampledBy<GaussianTooNarrow>>("SampledBy<GaussianTooNarrow>", "gaussian sampler"),
            defect<SampledBy<GaussianDrifts>>("SampledBy<GaussianDrifts>", "gaussian sampler")};
}

TEST(StateSpaceConformance, FindsEveryDefect)
{
    for (const Defect &defect : allDefects())
    {
        const auto failures = conformanceFailures(defect.makeSpace, defect.promises, 9);
        const auto names = [&defect](const std::string &failure)
        {
            return failure.rfind(defect.rule + ":", 0) == 0;
        };
        EXPECT_TRUE(std::any_of(failures.begin(), failures.end(), names))
            << defect.name << " does not break the rule about " << defect.rule << textOf(failures);
    }
}

TEST(StateSpaceConformance, FindsNothingWhereThereIsNoDefect)
{
    expectConforms(factoryOf<defects::Sound>(small), promisesOf<defects::Sound>(small), 9);
    expectConforms(factoryOf<defects::SampledBy<defects::PassingSampler>>(large),
                   promisesOf<defects::SampledBy<defects::PassingSampler>>(large), 9);
}

TEST(StateSpaceConformance, ASpaceThatIsNotCountedIsNoConformingOne)
{
    const auto makeSpace = []
    {
        return std::make_shared<HexStateSpace>(small);
    };
    const auto failures = conformanceFailures(makeSpace, promisesOf<HexStateSpace>(small), 9);
    ASSERT_EQ(failures.size(), 1U) << textOf(failures);
    EXPECT_EQ(failures[0].rfind("states: not counted", 0), 0U) << failures[0];
}

}  // namespace
}  // namespace seahex::test
