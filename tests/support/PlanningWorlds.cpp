#include "support/PlanningWorlds.h"

#include "support/CellOracle.h"

#include <seahex/planning/HexStateSpace.h>
#include <seahex/planning/OccupancyMotionValidator.h>
#include <seahex/planning/OccupancyValidityChecker.h>
#include <seahex/planning/PlanarEmbedding.h>
#include <seahex/planning/Setup.h>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <limits>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{

ob::StateSpacePtr spaceWithin(const Box &bounds, SpaceKind kind)
{
    // OMPL tells the console about every skipped state
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    ob::RealVectorBounds box(2);
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
        box.setLow(axis, bounds.min[axis]);
        box.setHigh(axis, bounds.max[axis]);
    }
    if (kind == SpaceKind::Pose)
    {
        auto space = std::make_shared<ob::SE2StateSpace>();
        space->setBounds(box);
        return space;
    }
    if (kind == SpaceKind::Cells)
        return std::make_shared<HexStateSpace>(HexLattice::covering(bounds, 1.0));
    auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(box);
    return space;
}

ob::SpaceInformationPtr chartSpace(const std::shared_ptr<const Occupancy> &occupancy, SpaceKind kind)
{
    return chartSpace(occupancy, kind, occupancy->lattice().bounds());
}

ob::SpaceInformationPtr chartSpace(const std::shared_ptr<const Occupancy> &occupancy, SpaceKind kind, const Box &bounds)
{
    auto si = std::make_shared<ob::SpaceInformation>(kind == SpaceKind::Cells
                                                         ? latticeSpace(dynamic_cast<const HexOccupancy &>(*occupancy))
                                                         : spaceWithin(bounds, kind));
    si->setStateValidityChecker(std::make_shared<OccupancyValidityChecker>(si, occupancy));
    si->setMotionValidator(std::make_shared<OccupancyMotionValidator>(si, occupancy));
    si->setup();
    return si;
}

ob::SpaceInformationPtr userSpace(const Box &bounds, SpaceKind kind, const ob::StateValidityCheckerFn &isValid)
{
    auto si = std::make_shared<ob::SpaceInformation>(spaceWithin(bounds, kind));
    si->setStateValidityChecker(isValid);
    si->setup();
    return si;
}

ob::ScopedState<> stateAt(const ob::SpaceInformationPtr &si, const Point &p, double heading)
{
    ob::ScopedState<> state(si);
    PlanarEmbedding(si->getStateSpace().get()).place(state.get(), p, heading);
    return state;
}

Point positionOf(const ob::SpaceInformationPtr &si, const ob::State *state)
{
    return PlanarEmbedding(si->getStateSpace().get()).position(state);
}

ob::ProblemDefinitionPtr problemBetween(const ob::SpaceInformationPtr &si, const Point &start, const Point &goal)
{
    auto problem = std::make_shared<ob::ProblemDefinition>(si);
    problem->setStartAndGoalStates(stateAt(si, start), stateAt(si, goal));
    return problem;
}

std::shared_ptr<og::PathGeometric> pathOf(const ob::ProblemDefinitionPtr &problem)
{
    return std::dynamic_pointer_cast<og::PathGeometric>(problem->getSolutionPath());
}

double lengthOf(const og::PathGeometric &path)
{
    double length = 0.0;
    for (unsigned int i = 1; i < path.getStateCount(); ++i)
        length += (positionOf(path.getSpaceInformation(), path.getState(i)) -
                   positionOf(path.getSpaceInformation(), path.getState(i - 1)))
                      .norm();
    return length;
}

namespace
{

template <class LatticeType>
long double distanceToBlocked(const Occupancy &occupancy, const LatticeType &lattice, const Point &a, const Point &b)
{
    const CellOracle<LatticeType> oracle(lattice);
    long double least = std::numeric_limits<long double>::infinity();
    forEachCell(lattice, 2,
                [&](typename LatticeType::Cell cell)
                {
                    if (occupancy.isBlocked(toOffset(cell)))
                        least = std::min(least, oracle.distance(a, b, cell));
                });
    return least;
}

template <class LatticeType>
Point anyPoint(Random &random, const LatticeType &lattice)
{
    const auto cell = random.cellOf(lattice);
    return random.chance(0.5) ? random.pointOf(lattice, cell) : lattice.centre(cell);
}

}  // namespace

long double distanceToBlocked(const Occupancy &occupancy, const Point &a, const Point &b)
{
    const Lattice &lattice = occupancy.lattice();
    return lattice.hexagons() != nullptr ? distanceToBlocked(occupancy, *lattice.hexagons(), a, b)
                                         : distanceToBlocked(occupancy, *lattice.squares(), a, b);
}

Point freePoint(Random &random, const Occupancy &occupancy)
{
    const Lattice &lattice = occupancy.lattice();
    for (;;)
    {
        const Point p = lattice.hexagons() != nullptr ? anyPoint(random, *lattice.hexagons())
                                                      : anyPoint(random, *lattice.squares());
        if (distanceToBlocked(occupancy, p, p) > 1e-6 * lattice.pitch())
            return p;
    }
}

bool Discs::isFree(const Point &a, const Point &b) const
{
    for (std::size_t i = 0; i < centres.size(); ++i)
    {
        const Point d = b - a;
        const double square = d.squaredNorm();
        const double t = square > 0.0 ? std::clamp((centres[i] - a).dot(d) / square, 0.0, 1.0) : 0.0;
        if ((a + t * d - centres[i]).norm() <= radii[i])
            return false;
    }
    return true;
}

Discs randomDiscs(Random &random, const Box &box, int most)
{
    Discs discs;
    const double size = (box.max - box.min).maxCoeff();
    for (std::int64_t i = random.integer(0, most); i > 0; --i)
    {
        discs.centres.push_back(random.pointIn(box));
        discs.radii.push_back(random.real(0.02, 0.15) * size);
    }
    for (std::int64_t walls = random.integer(0, 2); walls > 0; --walls)
    {
        const Point a = random.pointIn(box);
        const Point b = random.pointIn(box);
        for (int i = 0; i <= 10; ++i)
        {
            discs.centres.push_back(a + 0.1 * i * (b - a));
            discs.radii.push_back(std::max(0.06 * (b - a).norm(), 0.01 * size));
        }
    }
    return discs;
}

}  // namespace seahex::test
