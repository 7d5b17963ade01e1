#pragma once

#include <seahex/planning/HexAStar.h>
#include <seahex/planning/OccupancyMotionValidator.h>
#include <seahex/planning/OccupancyValidityChecker.h>
#include <seahex/planning/SquareAStar.h>
#include <seahex/planning/TurnAngleObjective.h>
#include <seahex/planning/TurnCountObjective.h>
#include <seahex/planning/WeightedSumObjective.h>
#include <seahex/world/CellBits.h>

#include "planning/PoseGraph.h"
#include "support/PlanningWorlds.h"

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <cmath>

namespace seahex::test
{

// Random problems in SE(2) whose objectives charge length and turns, and what the best path of their lattice costs.

inline std::shared_ptr<const Occupancy> randomCells(Random &random, bool hexagons)
{
    const Point corner(random.real(-5, 5), random.real(-5, 5));
    const double pitch = random.chance(0.3) ? 1.0 : random.real(0.7, 20.0);
    const double density = random.real(0.0, 0.35);
    if (hexagons)
        return randomOccupancy(random, HexLattice(corner, pitch, 6, 6), density);
    const SquareLattice lattice(corner, pitch, 6, 6);
    const CellLayout layout(6, 6);
    CellBits bits(layout);
    bits.setOutside();
    for (std::int64_t i = 0; i < 36; ++i)
        if (random.chance(density))
            bits.setSpan(i / 6, i % 6, i % 6);
    return std::make_shared<const SquareOccupancy>(lattice, layout, bits.words());
}

/// SE(2) on an occupancy; a radian of yaw weighs as much as `yawWeight` units of length.
inline ompl::base::SpaceInformationPtr poses(const std::shared_ptr<const Occupancy> &occupancy, double yawWeight = 0.5)
{
    const auto space = spaceWithin(occupancy->lattice().bounds(), SpaceKind::Pose);
    space->as<ompl::base::SE2StateSpace>()->setSubspaceWeight(1, yawWeight);
    auto si = std::make_shared<ompl::base::SpaceInformation>(space);
    si->setStateValidityChecker(std::make_shared<OccupancyValidityChecker>(si, occupancy));
    si->setMotionValidator(std::make_shared<OccupancyMotionValidator>(si, occupancy));
    si->setup();
    return si;
}

/// Any sum of what turn-aware search knows.
inline ompl::base::OptimizationObjectivePtr randomObjective(Random &random, const ompl::base::SpaceInformationPtr &si,
                                                            int depth = 0)
{
    switch (random.integer(0, depth < 2 ? 4 : 2))
    {
        case 0:
            return std::make_shared<ompl::base::PathLengthOptimizationObjective>(si);
        case 1:
            return std::make_shared<TurnCountObjective>(si);
        case 2:
            return std::make_shared<TurnAngleObjective>(si);
        default:
            break;
    }
    const std::shared_ptr<ompl::base::MultiOptimizationObjective> sum =
        random.chance(0.3) ? std::make_shared<ompl::base::MultiOptimizationObjective>(si)
                           : std::make_shared<WeightedSumObjective>(si);
    for (std::int64_t parts = random.integer(1, 3); parts > 0; --parts)
        sum->addObjective(randomObjective(random, si, depth + 1), random.chance(0.1) ? 0.0 : random.real(0.0, 5.0));
    return sum;
}

/// Length alone, length with turns at a price that is now and then worth a detour, or any sum.
inline ompl::base::OptimizationObjectivePtr anyObjective(Random &random, const ompl::base::SpaceInformationPtr &si,
                                                         double pitch)
{
    const auto length = std::make_shared<ompl::base::PathLengthOptimizationObjective>(si);
    if (random.chance(0.2))
        return length;
    if (random.chance(0.6))
        return randomObjective(random, si);
    const double price = pitch * random.real(0.0, 1.5);
    return std::make_shared<WeightedSumObjective>(
        si, std::vector<WeightedSumObjective::Part>{{length, 1.0}, {std::make_shared<TurnCountObjective>(si), price}});
}

/// A pose in a free cell: now and then at its centre, now and then with the course of a jump.
inline ompl::base::ScopedState<> randomPose(Random &random, const ompl::base::SpaceInformationPtr &si,
                                            const Occupancy &occupancy)
{
    const Lattice &lattice = occupancy.lattice();
    for (;;)
    {
        const Point p = random.pointIn(lattice.bounds());
        const OffsetCoord cell = lattice.cellAt(p);
        const double heading =
            random.chance(0.4) ? M_PI / 6.0 * static_cast<double>(random.integer(-6, 5)) : random.real(-M_PI, M_PI);
        const auto state = stateAt(si, random.chance(0.4) ? lattice.centre(cell) : p, heading);
        if (occupancy.isFree(cell) && si->isValid(state.get()))
            return state;
    }
}

/// A problem in SE(2), its planner, and the best cost of its lattice by PoseGraph.
struct TurnQuery
{
    std::shared_ptr<const Occupancy> occupancy;
    ompl::base::SpaceInformationPtr si;
    ompl::base::ProblemDefinitionPtr problem;
    std::shared_ptr<LatticeAStar> planner;
    double best = 0.0;
    std::string text;

    explicit TurnQuery(Random &random) : TurnQuery(random, random.chance(0.6)) {}

    TurnQuery(Random &random, bool hexagons)
        : occupancy(randomCells(random, hexagons)),
          si(poses(occupancy, random.chance(0.4) ? 0.5 : random.real(0.0, random.chance(0.5) ? 1.0 : 30.0))),
          problem(std::make_shared<ompl::base::ProblemDefinition>(si))
    {
        std::vector<const ompl::base::State *> starts;
        std::vector<const ompl::base::State *> goals;
        const auto goalStates = std::make_shared<ompl::base::GoalStates>(si);
        for (std::int64_t n = random.integer(1, 3); n > 0; --n)
            starts_.push_back(randomPose(random, si, *occupancy));
        for (std::int64_t n = random.integer(1, 3); n > 0; --n)
            goals_.push_back(randomPose(random, si, *occupancy));
        for (const ompl::base::ScopedState<> &start : starts_)
        {
            problem->addStartState(start);
            starts.push_back(start.get());
        }
        for (const ompl::base::ScopedState<> &goal : goals_)
        {
            goalStates->addState(goal);
            goals.push_back(goal.get());
        }
        problem->setGoal(goalStates);
        problem->setOptimizationObjective(anyObjective(random, si, occupancy->lattice().pitch()));
        const auto rings = static_cast<int>(random.integer(1, 3));
        const int neighbours = random.chance(0.5) ? 4 : 8;
        if (hexagons)
        {
            const auto hex = std::make_shared<HexAStar>(si);
            hex->setRings(rings);
            hex->setAnytime(random.chance(0.3));
            hex->setAllJumps(random.chance(0.3));
            planner = hex;
        }
        else
        {
            const auto square = std::make_shared<SquareAStar>(si);
            square->setNeighbours(neighbours);
            planner = square;
        }
        planner->setSmoothing(false);
        planner->setGuidance(random.chance(0.3)   ? Guidance::None
                             : random.chance(0.7) ? Guidance::Distance
                                                  : Guidance::TieBreak);
        planner->setProblemDefinition(problem);
        const auto isStep = [=](OffsetCoord a, OffsetCoord b)
        {
            if (hexagons)
                return hexDistance(toCube(a), toCube(b)) <= rings;
            const std::int64_t columns = std::abs(a.column - b.column);
            const std::int64_t rows = std::abs(a.row - b.row);
            return neighbours == 4 ? columns + rows == 1 : std::max(columns, rows) == 1;
        };
        best = PoseGraph(*problem, *occupancy, isStep).cheapest(starts, goals);
        text = (hexagons ? "hexagons, rings " + std::to_string(rings) : "squares, " + std::to_string(neighbours)) +
               ", guidance " + planner->getGuidance();
    }

    /// A start and a goal in one cell are joined by a motion of their own.
    bool hasPairInOneCell() const
    {
        const Lattice &lattice = occupancy->lattice();
        for (const ompl::base::ScopedState<> &start : starts_)
            for (const ompl::base::ScopedState<> &goal : goals_)
                if (lattice.cellAt(positionOf(si, start.get())) == lattice.cellAt(positionOf(si, goal.get())))
                    return true;
        return false;
    }

private:
    std::vector<ompl::base::ScopedState<>> starts_;
    std::vector<ompl::base::ScopedState<>> goals_;
};

}  // namespace seahex::test
