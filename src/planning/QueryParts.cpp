#include "planning/QueryParts.h"

#include "seahex/geometry/HexNorm.h"
#include "seahex/planning/LatticeLengthObjective.h"

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <typeinfo>

namespace ob = ompl::base;

namespace seahex
{
namespace
{

std::optional<LengthMetric> lengthMetric(const LatticeQuestion &question)
{
    const ob::OptimizationObjective &objective = *question.objective;
    if (typeid(objective) == typeid(ob::PathLengthOptimizationObjective))
        return LengthMetric::Euclidean;
    if (typeid(objective) == typeid(LatticeLengthObjective) &&
        static_cast<const LatticeLengthObjective &>(objective).lattice().pitch() == question.lattice.pitch())
        return LengthMetric::Lattice;
    return std::nullopt;
}

}  // namespace

QueryParts::QueryParts(const LatticeQuestion &q)
    : question(q), embedding(q.si->getStateSpace().get()), metric(lengthMetric(q)),
      layout(q.occupancy ? q.occupancy->layout() : CellLayout(q.lattice.columns(), q.lattice.rows())),
      jumps(layout, q.rings, q.allJumps || !metric ? JumpSet::All : JumpSet::Primitive), scratch_(q.si)
{
    if (!q.occupancy || !q.direct)
        cache = std::make_unique<MotionCache>(q.si, embedding, q.lattice, layout, jumps, q.occupancy != nullptr);
    if (!q.occupancy && embedding.lattice() == nullptr)
        for (const RingOffset &offset : ringOffsets(1))
            around_.push_back(offset.offset);
}

bool QueryParts::join()
{
    for (; tried_ < (question.starts.size() + question.goals.size()) * around_.size(); ++tried_)
    {
        if (cache && cache->interrupted())
            return false;
        const std::size_t i = tried_ / around_.size();
        const bool isStart = i < question.starts.size();
        const ob::State *state = isStart ? question.starts[i] : question.goals[i - question.starts.size()];
        const HexCoord own = question.lattice.cellAt(embedding.position(state));
        tryJoin(state, own + around_[tried_ % around_.size()], isStart);
    }
    goals = joinedGoals;
    for (const Joint &joint : starts)
        startHeadings[layout.index(joint.cell)] = jointHeading(best(starts, joint.cell).state, joint.cell, true);
    return true;
}

void QueryParts::restore()
{
    goals = joinedGoals;
    if (cache)
        cache->allowAll();
}

double QueryParts::jointHeading(const ob::State *state, HexCoord cell, bool isStart) const
{
    const Point p = embedding.position(state);
    const Point centre = question.lattice.centre(cell);
    if (p == centre)
        return embedding.heading(state);
    return isStart ? courseBetween(p, centre) : courseBetween(centre, p);
}

const Joint &QueryParts::best(const std::vector<Joint> &joints, HexCoord cell) const
{
    const Joint *best = nullptr;
    for (const Joint &joint : joints)
        if (joint.cell == cell &&
            (best == nullptr || question.objective->isCostBetterThan(ob::Cost(joint.cost), ob::Cost(best->cost))))
            best = &joint;
    return *best;
}

std::vector<GoalCell> QueryParts::goalCells() const
{
    std::vector<GoalCell> cells;
    for (const Joint &joint : goals)
        cells.push_back({joint.cell, joint.cost});
    return cells;
}

double QueryParts::unit() const
{
    return metric == LengthMetric::Euclidean ? question.lattice.pitch() * embedding.lengthWeight() : 1.0;
}

bool QueryParts::coincide(const ob::State *state, HexCoord cell) const
{
    return !embedding.hasHeading() && embedding.position(state) == question.lattice.centre(cell);
}

void QueryParts::tryJoin(const ob::State *state, HexCoord cell, bool isStart)
{
    if (!cache)
    {
        if (question.occupancy->isFree(cell))
            add(state, cell, isStart);
        return;
    }
    if (!question.lattice.contains(cell) || !cache->isCellUsable(layout.index(cell)))
        return;
    placeCentre(state, cell, isStart);
    if (embedding.hasHeading() && !cache->ask(question.si->isValid(scratch_.get())))
        return;
    if (cache->ask(isStart ? question.si->checkMotion(state, scratch_.get())
                           : question.si->checkMotion(scratch_.get(), state)))
        add(state, cell, isStart);
}

void QueryParts::placeCentre(const ob::State *state, HexCoord cell, bool isStart)
{
    embedding.place(scratch_.get(), question.lattice.centre(cell), jointHeading(state, cell, isStart));
}

void QueryParts::add(const ob::State *state, HexCoord cell, bool isStart)
{
    (isStart ? starts : joinedGoals).push_back({cell, jointCost(state, cell, isStart), state});
}

double QueryParts::jointCost(const ob::State *state, HexCoord cell, bool isStart)
{
    const Point leg = question.lattice.centre(cell) - embedding.position(state);
    if (metric == LengthMetric::Euclidean)
        return leg.norm() / question.lattice.pitch();
    if (metric == LengthMetric::Lattice)
        return hexNorm(leg, question.lattice);
    const ob::OptimizationObjective &objective = *question.objective;
    if (coincide(state, cell))
        return (isStart ? objective.initialCost(state) : objective.terminalCost(state)).value();
    placeCentre(state, cell, isStart);
    return isStart ? objective.combineCosts(objective.initialCost(state), objective.motionCost(state, scratch_.get()))
                         .value()
                   : objective.combineCosts(objective.motionCost(scratch_.get(), state), objective.terminalCost(state))
                         .value();
}

}  // namespace seahex
