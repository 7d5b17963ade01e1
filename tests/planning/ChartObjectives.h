#pragma once

#include <seahex/planning/ClearanceObjective.h>
#include <seahex/planning/LatticeLengthObjective.h>
#include <seahex/planning/SafetyWeightObjective.h>
#include <seahex/planning/WeightedSumObjective.h>

#include "support/AsciiWorld.h"
#include "support/PlanningWorlds.h"
#include "support/Random.h"

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace seahex::test
{

// Objectives for charts of any cells: those whose costs a search knows beforehand, and others.

/// Hills over the plane, climbed at a price.
class HillsObjective : public ompl::base::StateCostIntegralObjective
{
public:
    explicit HillsObjective(const ompl::base::SpaceInformationPtr &si)
        : ompl::base::StateCostIntegralObjective(si, false)
    {
    }
    ompl::base::Cost stateCost(const ompl::base::State *state) const override
    {
        const Point p = positionOf(si_, state);
        return ompl::base::Cost(1.2 + std::sin(0.7 * p.x()) * std::cos(0.9 * p.y()));
    }
    ompl::base::Cost motionCost(const ompl::base::State *s1, const ompl::base::State *s2) const override
    {
        const double length = (positionOf(si_, s2) - positionOf(si_, s1)).norm();
        return ompl::base::Cost(0.5 * length * (stateCost(s1).value() + stateCost(s2).value()));
    }
};

using MakeChartObjective =
    std::function<ompl::base::OptimizationObjectivePtr(const ompl::base::SpaceInformationPtr &, const Occupancy &)>;

struct ChartObjective
{
    std::string name;
    bool looksAtYaw;
    MakeChartObjective make;
};

/// An occupancy of hexagons about the lattice of another, for weights that are not the searched lattice's.
inline std::shared_ptr<const Occupancy> otherCells(const Occupancy &occupancy)
{
    Random random(7);
    const HexLattice lattice = HexLattice::covering(occupancy.lattice().bounds(), 0.8 * occupancy.lattice().pitch());
    return randomOccupancy(random, lattice, 0.3);
}

inline const std::vector<ChartObjective> chartObjectives = {
    {"length", true,
     [](const auto &si, const auto &)
     {
         return std::make_shared<ompl::base::PathLengthOptimizationObjective>(si);
     }},
    {"lattice length", false,
     [](const auto &si, const auto &occupancy)
     {
         return std::make_shared<LatticeLengthObjective>(si, occupancy.lattice());
     }},
    {"safety weight", false,
     [](const auto &si, const auto &occupancy)
     {
         return std::make_shared<SafetyWeightObjective>(si, occupancy, SafetyCharge::OnArrival);
     }},
    {"safety weight of other cells", false,
     [](const auto &si, const auto &occupancy)
     {
         return std::make_shared<SafetyWeightObjective>(si, *otherCells(occupancy), SafetyCharge::OnArrival);
     }},
    {"weighted sum", true,
     [](const auto &si, const auto &occupancy)
     {
         return std::make_shared<WeightedSumObjective>(
             si, std::vector<WeightedSumObjective::Part>{
                     {std::make_shared<ompl::base::PathLengthOptimizationObjective>(si), 0.7},
                     {std::make_shared<SafetyWeightObjective>(si, occupancy, SafetyCharge::OnArrival), 0.3}});
     }},
    {"safety weight along the line", false,
     [](const auto &si, const auto &occupancy)
     {
         return std::make_shared<SafetyWeightObjective>(si, occupancy, SafetyCharge::AlongLine);
     }},
    {"clearance", false,
     [](const auto &si, const auto &occupancy)
     {
         return std::make_shared<ClearanceObjective>(si, occupancy, 3.0 * occupancy.lattice().pitch(), 4.0);
     }},
    {"hills", false,
     [](const auto &si, const auto &)
     {
         return std::make_shared<HillsObjective>(si);
     }},
};

}  // namespace seahex::test
