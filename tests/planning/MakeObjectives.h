#pragma once

#include <seahex/planning/ClearanceObjective.h>
#include <seahex/planning/SafetyWeightObjective.h>
#include <seahex/planning/TurnAngleObjective.h>
#include <seahex/planning/TurnCountObjective.h>
#include <seahex/planning/WeightedSumObjective.h>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <functional>
#include <memory>
#include <ostream>
#include <vector>

namespace seahex::test
{

// The project's objectives and sums of them, for tests that try all of them on one occupancy.

using MakeObjective =
    std::function<ompl::base::OptimizationObjectivePtr(const ompl::base::SpaceInformationPtr &, const HexOccupancy &)>;

struct NamedObjective
{
    const char *name;
    MakeObjective make;
};

inline std::ostream &operator<<(std::ostream &out, const NamedObjective &objective)
{
    return out << objective.name;
}

inline ompl::base::OptimizationObjectivePtr safetyOnArrival(const ompl::base::SpaceInformationPtr &si,
                                                            const HexOccupancy &occupancy)
{
    return std::make_shared<SafetyWeightObjective>(si, occupancy, SafetyCharge::OnArrival);
}

inline ompl::base::OptimizationObjectivePtr safetyAlongLine(const ompl::base::SpaceInformationPtr &si,
                                                            const HexOccupancy &occupancy)
{
    return std::make_shared<SafetyWeightObjective>(si, occupancy);
}

inline ompl::base::OptimizationObjectivePtr clearance(const ompl::base::SpaceInformationPtr &si,
                                                      const HexOccupancy &occupancy)
{
    return std::make_shared<ClearanceObjective>(si, occupancy, 3.0 * occupancy.lattice().pitch(), 4.0);
}

inline std::vector<WeightedSumObjective::Part> parts(const ompl::base::SpaceInformationPtr &si,
                                                     const HexOccupancy &occupancy)
{
    std::vector<WeightedSumObjective::Part> parts = {
        {std::make_shared<ompl::base::PathLengthOptimizationObjective>(si), 0.7},
        {safetyAlongLine(si, occupancy), 0.3},
        {clearance(si, occupancy), 0.4}};
    if (si->getStateSpace()->getType() == ompl::base::STATE_SPACE_SE2)
    {
        parts.emplace_back(std::make_shared<TurnAngleObjective>(si), 0.8);
        parts.emplace_back(std::make_shared<TurnCountObjective>(si), 0.2);
    }
    return parts;
}

inline ompl::base::OptimizationObjectivePtr weightedSum(const ompl::base::SpaceInformationPtr &si,
                                                        const HexOccupancy &occupancy)
{
    return std::make_shared<WeightedSumObjective>(si, parts(si, occupancy));
}

inline ompl::base::OptimizationObjectivePtr asymmetricSum(const ompl::base::SpaceInformationPtr &si,
                                                          const HexOccupancy &occupancy)
{
    return std::make_shared<WeightedSumObjective>(
        si, std::vector<WeightedSumObjective::Part>{
                {safetyOnArrival(si, occupancy), 1.0},
                {std::make_shared<ompl::base::PathLengthOptimizationObjective>(si), 0.5}});
}

inline ompl::base::OptimizationObjectivePtr omplsSum(const ompl::base::SpaceInformationPtr &si,
                                                     const HexOccupancy &occupancy)
{
    const auto sum = std::make_shared<ompl::base::MultiOptimizationObjective>(si);
    for (const auto &[objective, weight] : parts(si, occupancy))
        sum->addObjective(objective, weight);
    return sum;
}

}  // namespace seahex::test
