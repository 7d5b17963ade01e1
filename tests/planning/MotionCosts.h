#pragma once

#include "support/PlanningWorlds.h"

#include <ompl/base/OptimizationObjective.h>

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace seahex::test
{

/// What an objective charges for going straight from point to point, yaws being 0.
inline double motionCost(const ompl::base::OptimizationObjective &objective, const Point &a, const Point &b)
{
    const auto &si = objective.getSpaceInformation();
    return objective.motionCost(stateAt(si, a).get(), stateAt(si, b).get()).value();
}

/// Its heuristic for the same.
inline double heuristic(const ompl::base::OptimizationObjective &objective, const Point &a, const Point &b)
{
    const auto &si = objective.getSpaceInformation();
    return objective.motionCostHeuristic(stateAt(si, a).get(), stateAt(si, b).get()).value();
}

/// A point of the lattice's box, now and then on an edge, a corner or a centre.
template <class LatticeType>
Point anyPoint(Random &random, const LatticeType &lattice)
{
    return random.chance(0.5) ? random.pointOf(lattice, random.cellOf(lattice)) : random.pointIn(lattice.bounds());
}

/// Two threads that ask for the costs of the same motions at the same time get the answers that one gets alone.
template <class LatticeType>
void expectSameFromTwoThreads(const ompl::base::OptimizationObjective &objective, const LatticeType &lattice)
{
    Random random(1);
    std::vector<std::pair<Point, Point>> motions;
    for (int i = 0; i < 300; ++i)
    {
        const Point from = anyPoint(random, lattice);
        motions.emplace_back(from, anyPoint(random, lattice));
    }
    const auto costs = [&]
    {
        std::vector<double> answers;
        for (int pass = 0; pass < 5; ++pass)
            for (const auto &[from, to] : motions)
            {
                answers.push_back(motionCost(objective, from, to));
                answers.push_back(heuristic(objective, from, to));
            }
        return answers;
    };
    const std::vector<double> expected = costs();
    std::vector<double> first;
    std::vector<double> second;
    std::thread one([&] { first = costs(); });
    std::thread other([&] { second = costs(); });
    one.join();
    other.join();
    EXPECT_EQ(first, expected);
    EXPECT_EQ(second, expected);
}

}  // namespace seahex::test
