#pragma once

#include "planning/PrismGround.h"
#include "planning/SpacePrisms.h"
#include "seahex/search/AStar.h"
#include "seahex/search/PrismGraph.h"

#include <memory>
#include <vector>

namespace seahex
{

/// The search on one prism lattice, between all starts and all goals: join them to nodes, find the shortest path. It
/// may be interrupted at any question.
class PrismQuery
{
public:
    enum class Step
    {
        Found,       ///< path() is the shortest there is on the lattice
        Exhausted,   ///< there is none
        Interrupted  ///< no time: work() again continues
    };

    /// The ground must outlive the query.
    PrismQuery(const PrismGround &ground, const PrismLattice &lattice, int rings, std::vector<Point3> starts,
               std::vector<Point3> goals);

    Step work(SpaceJudge &judge);

    const PrismLattice &lattice() const { return lattice_; }
    /// From a start to a goal, nodes between.
    std::vector<Point3> path() const;
    SearchCounters counters() const { return search_ ? search_->counters() : SearchCounters(); }
    std::size_t openSize() const { return search_ ? search_->openSize() : 0; }

private:
    struct Joint
    {
        CellIndex state;
        double length;  // in pitches
        std::size_t end;
    };

    bool join(SpaceJudge &judge);
    std::vector<Joint> jointsOf(const std::vector<Point3> &ends, bool isStart, PrismQuestions &questions) const;
    const Point3 &endOf(CellIndex state, const std::vector<Joint> &joints, const std::vector<Point3> &ends) const;

    const PrismGround &ground_;
    PrismLattice lattice_;
    CellLayout layout_;
    PrismMoves moves_;
    std::vector<Point3> starts_;
    std::vector<Point3> goals_;
    std::vector<bool> answers_;
    std::vector<Joint> startJoints_;
    std::vector<Joint> goalJoints_;
    std::unique_ptr<SpacePrisms> asked_;  // where the problem must be
    std::unique_ptr<PrismMotions> read_;  // where it need not
    std::unique_ptr<PrismGraph> graph_;
    std::unique_ptr<AStar<PrismGraph>> search_;
};

}  // namespace seahex
