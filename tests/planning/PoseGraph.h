#pragma once

#include <seahex/planning/PlanarEmbedding.h>
#include <seahex/world/Occupancy.h>

#include "support/ExplicitGraph.h"
#include "support/PlanningWorlds.h"

#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace seahex::test
{

/// The lattice of a problem written out: a vertex for each cell and the step that led there, and one for each start at
/// its cell's centre. All costs are the objective's own.
class PoseGraph
{
public:
    /// @param steps  the most columns and rows that a jump goes; `isStep` says which of them are jumps
    PoseGraph(const ompl::base::ProblemDefinition &problem, const Occupancy &occupancy,
              std::function<bool(OffsetCoord, OffsetCoord)> isStep)
        : si_(problem.getSpaceInformation()), objective_(*problem.getOptimizationObjective()), occupancy_(occupancy),
          lattice_(occupancy.lattice()), isStep_(std::move(isStep))
    {
        forEachFree(
            [&](OffsetCoord from)
            {
                forEachFree(
                    [&](OffsetCoord to)
                    {
                        if (from == to || !isStep_(from, to))
                            return;
                        if (si_->checkMotion(pose(from, 0.0).get(), pose(to, 0.0).get()))
                            arrivals_[key(to)].push_back({from, course(lattice_.centre(from), lattice_.centre(to))});
                    });
            });
    }

    double cheapest(const std::vector<const ompl::base::State *> &starts,
                    const std::vector<const ompl::base::State *> &goals)
    {
        // vertices: (cell, step that led there) and (start)
        std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> vertex;
        std::vector<std::pair<OffsetCoord, double>> poses;
        forEachFree(
            [&](OffsetCoord to)
            {
                for (const Arrival &arrival : arrivals_[key(to)])
                {
                    vertex[{key(arrival.from), key(to)}] = poses.size();
                    poses.emplace_back(to, arrival.course);
                }
            });
        const std::size_t arrived = poses.size();
        std::vector<ExplicitGraph::Terminal> entries;
        for (const ompl::base::State *start : starts)
        {
            const Point p = positionOf(si_, start);
            const OffsetCoord cell = lattice_.cellAt(p);
            const Point centre = lattice_.centre(cell);
            poses.emplace_back(cell, p == centre ? PlanarEmbedding(si_->getStateSpace().get()).heading(start)
                                                 : course(p, centre));
            entries.emplace_back(poses.size() - 1, objective_.motionCost(start, pose(poses.back()).get()).value());
        }
        ExplicitGraph graph(poses.size());
        for (std::size_t i = 0; i < poses.size(); ++i)
            for (std::size_t j = 0; j < arrived; ++j)
            {
                const auto edge = vertex.find({key(poses[i].first), key(poses[j].first)});
                if (edge != vertex.end() && edge->second == j)
                    graph.addEdge(i, j, objective_.motionCost(pose(poses[i]).get(), pose(poses[j]).get()).value());
            }
        std::vector<ExplicitGraph::Terminal> exits;
        for (const ompl::base::State *goal : goals)
            for (std::size_t i = 0; i < poses.size(); ++i)
                if (lattice_.cellAt(positionOf(si_, goal)) == poses[i].first)
                    exits.emplace_back(i, objective_.motionCost(pose(poses[i]).get(), goal).value());
        return graph.cheapest(entries, exits);
    }

private:
    struct Arrival
    {
        OffsetCoord from;
        double course;
    };

    template <class Visit>
    void forEachFree(Visit &&visit)
    {
        for (std::int64_t row = 0; row < lattice_.rows(); ++row)
            for (std::int64_t column = 0; column < lattice_.columns(); ++column)
                if (occupancy_.isFree(OffsetCoord{column, row}))
                    visit(OffsetCoord{column, row});
    }

    std::int64_t key(OffsetCoord cell) const { return cell.row * lattice_.columns() + cell.column; }
    static double course(const Point &a, const Point &b) { return std::atan2(b.y() - a.y(), b.x() - a.x()); }
    ompl::base::ScopedState<> pose(OffsetCoord cell, double heading) const
    {
        return stateAt(si_, lattice_.centre(cell), heading);
    }
    ompl::base::ScopedState<> pose(const std::pair<OffsetCoord, double> &p) const { return pose(p.first, p.second); }

    ompl::base::SpaceInformationPtr si_;
    const ompl::base::OptimizationObjective &objective_;
    const Occupancy &occupancy_;
    Lattice lattice_;
    std::function<bool(OffsetCoord, OffsetCoord)> isStep_;
    std::map<std::int64_t, std::vector<Arrival>> arrivals_;
};

}  // namespace seahex::test
