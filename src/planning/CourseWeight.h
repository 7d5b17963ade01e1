#pragma once

#include "planning/Courses.h"
#include "planning/QueryParts.h"
#include "seahex/search/TurnWeight.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

namespace seahex
{

/// An objective that charges length and turns (CourseCosts) as the weight of a HeadingGraph. Costs are the objective's
/// own word: asked once for each pair of courses, as they hold anywhere in the plane, and where a path begins and ends.
/// The bound is made of what CourseCosts says.
///
/// Copies share their working states, so one weight serves one search at a time. The parts must outlive it.
template <class Norm>
class CourseWeight : public LatticeTurnWeight<Norm>
{
    using Turns = LatticeTurnWeight<Norm>;
    using Cost = ompl::base::Cost;

public:
    CourseWeight(const typename Norm::KnownLattice &lattice, const QueryParts &parts)
        : Turns(lattice, parts.jumps, LengthMetric::Euclidean, parts.courses->turns, parts.question.guidance,
                parts.firstStart(), parts.firstGoal(), parts.courses->perLength * lattice.pitch()),
          parts_(&parts), centres_(lattice, parts.jumps), courses_(coursesOf(parts.jumps)),
          from_(std::make_shared<ompl::base::ScopedState<>>(parts.question.si)),
          to_(std::make_shared<ompl::base::ScopedState<>>(parts.question.si))
    {
        for (std::size_t k = 0; k < courses_.size(); ++k)
            advances_.push_back(jumpCost(courses_[k], k));
        for (const double course : courses_)
            for (std::size_t k = 0; k < courses_.size(); ++k)
                turns_.push_back(turnFrom(course, k));
    }

    double turn(std::size_t from, std::size_t to) const { return turns_[from * courses_.size() + to]; }
    double advance(std::size_t jump) const { return advances_[jump]; }

    /// From a start to the cell's centre and on to the course of a jump, by the best of the starts that join there.
    double departure(CellIndex cell, std::size_t jump) const
    {
        return departureOf(*startFor(parts_->layout.offset(cell), jump), jump);
    }

    /// Which start that is; there must be one.
    const Joint *startFor(OffsetCoord cell, std::size_t jump) const
    {
        return cheapest(parts_->starts, cell, [&](const Joint &start) { return departureOf(start, jump); });
    }

    /// From a cell's centre, lying on the course of a jump, or of a start where the path begins in that cell, to a
    /// goal, by the best that joins there. Where it begins the way from the start is included.
    double arrival(CellIndex cell, std::size_t heading, const GoalCell &) const
    {
        const OffsetCoord at = parts_->layout.offset(cell);
        return arrivalOf(at, heading, *goalFor(at, heading));
    }

    const Joint *goalFor(OffsetCoord cell, std::size_t heading) const
    {
        return cheapest(parts_->goals, cell, [&](const Joint &goal) { return arrivalOf(cell, heading, goal); });
    }

    /// The start of a path that ends in the cell it begins in.
    const Joint *startTo(OffsetCoord cell, const Joint &goal) const
    {
        return cheapest(parts_->starts, cell,
                        [&](const Joint &start) { return start.cost + finish(cell, headingAfter(start), goal); });
    }

    double arrivalOf(OffsetCoord cell, std::size_t heading, const Joint &goal) const
    {
        if (heading < courses_.size())
            return finish(cell, courses_[heading], goal);
        const Joint &start = *startTo(cell, goal);
        return start.cost + finish(cell, headingAfter(start), goal);
    }

    /// Lengths tell paths of equal cost apart where they cost nothing.
    double tie(OffsetCoord cell, double bound) const
    {
        return Turns::tie(
            cell, parts_->courses->perLength > 0.0 ? bound : (parts_->firstGoal() - centres_.centre(cell)).norm());
    }

private:
    double headingAfter(const Joint &start) const { return parts_->jointHeading(start.state, start.cell, true); }

    double departureOf(const Joint &start, std::size_t jump) const
    {
        return start.cost + turnFrom(headingAfter(start), jump);
    }

    double finish(OffsetCoord cell, double heading, const Joint &goal) const
    {
        const ompl::base::OptimizationObjective &objective = *parts_->question.objective;
        parts_->embedding.place(from_->get(), centres_.centre(cell), heading);
        return objective
            .combineCosts(objective.motionCost(from_->get(), goal.state), objective.terminalCost(goal.state))
            .value();
    }

    double turnFrom(double heading, std::size_t jump) const
    {
        return std::max(jumpCost(heading, jump) - advances_[jump], 0.0);
    }

    /// A jump by itself, from any yaw.
    double jumpCost(double heading, std::size_t jump) const
    {
        const Point from = parts_->embedding.bounds().min;
        parts_->embedding.place(from_->get(), from, heading);
        parts_->embedding.place(to_->get(), from + centres_.pitch() * parts_->jumps.vector(jump), courses_[jump]);
        return parts_->question.objective->motionCost(from_->get(), to_->get()).value();
    }

    template <class CostOf>
    static const Joint *cheapest(const std::vector<Joint> &joints, OffsetCoord cell, CostOf &&costOf)
    {
        const Joint *best = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (const Joint &joint : joints)
            if (joint.cell == cell)
                if (const double cost = costOf(joint); best == nullptr || cost < least)
                {
                    best = &joint;
                    least = cost;
                }
        return best;
    }

    const QueryParts *parts_;
    Norm centres_;
    std::vector<double> courses_;  // of the jumps
    std::shared_ptr<ompl::base::ScopedState<>> from_;
    std::shared_ptr<ompl::base::ScopedState<>> to_;
    std::vector<double> advances_;
    std::vector<double> turns_;
};

}  // namespace seahex
