#pragma once

#include "planning/Courses.h"
#include "seahex/planning/AdmissibleHeuristic.h"
#include "seahex/planning/PlanarEmbedding.h"
#include "seahex/search/GoalCells.h"
#include "seahex/search/Guidance.h"
#include "seahex/search/Jumps.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace seahex
{

/// Any OMPL objective as the weight of a lattice graph: its own motion costs between cell centres, its own algebra, its
/// own heuristic. Copies share their working states, so one weight serves one search at a time.
class ObjectiveWeight
{
public:
    ObjectiveWeight(const ompl::base::SpaceInformationPtr &si, const ompl::base::OptimizationObjective &objective,
                    const PlanarEmbedding &embedding, const Lattice &lattice, const CellLayout &layout,
                    const Jumps &jumps, Guidance guidance, const Point &start, const Point &goal)
        : objective_(objective), embedding_(embedding), lattice_(lattice), layout_(layout), guidance_(guidance),
          start_(start), goal_(goal), from_(std::make_shared<ompl::base::ScopedState<>>(si)),
          to_(std::make_shared<ompl::base::ScopedState<>>(si)), courses_(coursesOf(jumps))
    {
    }

    void useRings(int) {}
    static bool sharpen(std::uint64_t) { return false; }

    double combine(double a, double b) const { return objective_.combineCosts(Cost(a), Cost(b)).value(); }
    bool better(double a, double b) const { return objective_.isCostBetterThan(Cost(a), Cost(b)); }
    bool improves(double cost, double known) const { return better(cost, known); }
    double worst() const { return objective_.infiniteCost().value(); }
    static double key(double estimate) { return estimate; }

    /// Where states have a yaw, the one at the first cell is the course of the jump that led there as the path stood
    /// when it was expanded.
    double jumpCost(CellIndex from, CellIndex to, std::size_t jump, std::uint8_t arrivedBy)
    {
        const double heading = courses_[jump];
        embedding_.place(from_->get(), lattice_.centre(layout_.offset(from)),
                         arrivedBy < courses_.size() ? courses_[arrivedBy] : heading);
        embedding_.place(to_->get(), lattice_.centre(layout_.offset(to)), heading);
        return objective_.motionCost(from_->get(), to_->get()).value();
    }

    /// The objective's heuristic between the two centres. Where states have a yaw it may count turns that the search
    /// does not charge, so nothing is assumed there.
    double bound(OffsetCoord cell, const GoalCell &goal) const
    {
        if (guidance_ == Guidance::None || embedding_.hasHeading())
            return objective_.identityCost().value();
        embedding_.place(from_->get(), lattice_.centre(cell));
        embedding_.place(to_->get(), lattice_.centre(goal.cell));
        return combine(admissibleHeuristic(objective_, from_->get(), to_->get()).value(), goal.finish);
    }

    double tie(OffsetCoord cell, double) const
    {
        const Point centre = lattice_.centre(cell);
        return guidance_ == Guidance::TieBreak ? distanceFromLine(start_, goal_, centre) : (goal_ - centre).norm();
    }

private:
    using Cost = ompl::base::Cost;

    const ompl::base::OptimizationObjective &objective_;
    PlanarEmbedding embedding_;
    Lattice lattice_;
    CellLayout layout_;
    Guidance guidance_;
    Point start_;
    Point goal_;
    std::shared_ptr<ompl::base::ScopedState<>> from_;
    std::shared_ptr<ompl::base::ScopedState<>> to_;
    std::vector<double> courses_;  // of the jumps
};

}  // namespace seahex
