#pragma once

#include "planning/CourseCosts.h"
#include "planning/Courses.h"
#include "planning/LatticeQuery.h"
#include "planning/MotionCache.h"
#include "seahex/planning/PlanarEmbedding.h"
#include "seahex/search/GoalCells.h"
#include "seahex/search/Jumps.h"
#include "seahex/search/LengthWeight.h"
#include "seahex/world/SafetyWeights.h"

#include <ompl/base/ScopedState.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace seahex
{

/// A leg between a start or goal state and a cell's centre.
struct Joint
{
    OffsetCoord cell;
    double cost;
    const ompl::base::State *state;
};

/// What all queries share: embedding, layout, jumps, and the joints of starts and goals.
class QueryParts
{
public:
    explicit QueryParts(const LatticeQuestion &q);

    /// Joins starts and goals to their cells. @return false if interrupted; call it again to go on
    bool join();

    /// The yaw at a centre that a start or goal joins: the course of the leg between them; the state's own where there
    /// is no way to go.
    double jointHeading(const ompl::base::State *state, OffsetCoord cell, bool isStart) const;

    /// Is a start or goal the centre of the cell, so that the two are one vertex of the path? Where states have a yaw
    /// they stay apart.
    bool coincide(const ompl::base::State *state, OffsetCoord cell) const;

    /// The cheapest of the joints to a cell, of which there must be one.
    const Joint &best(const std::vector<Joint> &joints, OffsetCoord cell) const;

    /// Leaves the cheapest joint of a goal to a cell out, because of the yaw with which the cell was reached.
    void dropGoal(OffsetCoord cell) { goals.erase(goals.begin() + (&best(goals, cell) - goals.data())); }

    /// Takes back what was left out, for a search in which cells may be reached with other yaws.
    void restore();

    std::vector<GoalCell> goalCells() const;

    Point firstStart() const { return embedding.position(question.starts.front()); }
    Point firstGoal() const { return embedding.position(question.goals.front()); }

    /// Does the search know the costs of jumps beforehand, and count them in pitches?
    bool isTabled() const { return metric || safety != nullptr; }

    /// What a unit of a search's cost is in the objective's: searches of lengths count in pitches.
    double unit() const;

    const LatticeQuestion question;
    const PlanarEmbedding embedding;
    /// Of an objective that charges turns, where the search can tell headings apart: in SE(2) on a chart that is read.
    const std::optional<CourseCosts> courses;
    const std::optional<LengthMetric> metric;  ///< of an objective that is a length, so that it need not be called
    /// Of an objective that charges them on arrival in this very lattice; elsewhere nullptr.
    const SafetyWeights *const safety;
    const CellLayout layout;
    const std::shared_ptr<const Jumps> jumpTable;
    const Jumps &jumps;
    std::unique_ptr<MotionCache> cache;  ///< where the problem is asked, not read
    std::vector<Joint> starts;
    std::vector<Joint> goals;  ///< less those that were dropped
    std::vector<Joint> joinedGoals;
    std::map<CellIndex, double> startHeadings;

private:
    void tryJoin(const ompl::base::State *state, OffsetCoord cell, bool isStart);
    void placeCentre(const ompl::base::State *state, OffsetCoord cell, bool isStart);
    void add(const ompl::base::State *state, OffsetCoord cell, bool isStart);
    double jointCost(const ompl::base::State *state, OffsetCoord cell, bool isStart);

    ompl::base::ScopedState<> scratch_;
    bool joinsAround_ = false;  // the cells around a state's own too
    std::size_t tried_ = 0;
};

}  // namespace seahex
