#include "planning/QueryParts.h"

#include "seahex/geometry/LatticeNorm.h"
#include "seahex/planning/LatticeLengthObjective.h"
#include "seahex/planning/SafetyWeightObjective.h"
#include "seahex/search/HeadingGraph.h"

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <typeinfo>

namespace ob = ompl::base;

namespace seahex
{
namespace
{

std::optional<CourseCosts> readableCourses(const LatticeQuestion &question)
{
    constexpr std::size_t mostJumps = 36;
    const bool isRead = question.occupancy && question.direct && question.knowsHeadings;
    if (!isRead || !headingsFit(question.occupancy->layout().size(), mostJumps))
        return std::nullopt;
    const std::optional<CourseCosts> costs = courseCosts(*question.objective);
    const bool areTurnsFree = costs && costs->turns.perTurn == 0.0 && costs->turns.perRadian == 0.0;
    return areTurnsFree ? std::nullopt : costs;
}

bool hasCellsOf(const Lattice &a, const Lattice &b)
{
    return a.pitch() == b.pitch() && (a.hexagons() == nullptr) == (b.hexagons() == nullptr);
}

std::optional<LengthMetric> lengthMetric(const LatticeQuestion &question)
{
    const ob::OptimizationObjective &objective = *question.objective;
    if (typeid(objective) == typeid(ob::PathLengthOptimizationObjective))
        return LengthMetric::Euclidean;
    if (typeid(objective) == typeid(LatticeLengthObjective) &&
        hasCellsOf(static_cast<const LatticeLengthObjective &>(objective).lattice(), question.lattice))
        return LengthMetric::Lattice;
    return std::nullopt;
}

const SafetyWeights *safetyWeights(const LatticeQuestion &question)
{
    const ob::OptimizationObjective &objective = *question.objective;
    if (typeid(objective) != typeid(SafetyWeightObjective))
        return nullptr;
    const auto &safety = static_cast<const SafetyWeightObjective &>(objective);
    const bool isKnown = safety.charge() == SafetyCharge::OnArrival && safety.weights().lattice() == question.lattice;
    return isKnown ? &safety.weights() : nullptr;
}

}  // namespace

QueryParts::QueryParts(const LatticeQuestion &q)
    : question(q), embedding(q.si->getStateSpace().get()), courses(readableCourses(q)),
      metric(courses ? std::nullopt : lengthMetric(q)), safety(safetyWeights(q)),
      layout(q.occupancy ? q.occupancy->layout() : CellLayout(q.lattice.columns(), q.lattice.rows())),
      jumpTable(makeJumps(q.lattice, layout, q.jumps, metric || courses)), jumps(*jumpTable), scratch_(q.si)
{
    if (!q.occupancy || !q.direct)
        cache = std::make_unique<MotionCache>(q.si, embedding, q.lattice, layout, jumps, q.jumps.rule,
                                              q.occupancy != nullptr);
    joinsAround_ = !q.occupancy && embedding.lattice() == nullptr;
}

bool QueryParts::join()
{
    const std::size_t around = joinsAround_ ? question.lattice.neighbours({0, 0}).size() + 1 : 1;
    for (; tried_ < (question.starts.size() + question.goals.size()) * around; ++tried_)
    {
        if (cache && cache->interrupted())
            return false;
        const std::size_t i = tried_ / around;
        const bool isStart = i < question.starts.size();
        const ob::State *state = isStart ? question.starts[i] : question.goals[i - question.starts.size()];
        const OffsetCoord own = question.lattice.cellAt(embedding.position(state));
        const std::size_t k = tried_ % around;
        tryJoin(state, k == 0 ? own : question.lattice.neighbours(own)[k - 1], isStart);
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

double QueryParts::jointHeading(const ob::State *state, OffsetCoord cell, bool isStart) const
{
    const Point p = embedding.position(state);
    const Point centre = question.lattice.centre(cell);
    if (p == centre)
        return embedding.heading(state);
    return isStart ? courseBetween(p, centre) : courseBetween(centre, p);
}

const Joint &QueryParts::best(const std::vector<Joint> &joints, OffsetCoord cell) const
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
    if (safety != nullptr)
        return question.lattice.pitch();
    return metric == LengthMetric::Euclidean ? question.lattice.pitch() * embedding.lengthWeight() : 1.0;
}

bool QueryParts::coincide(const ob::State *state, OffsetCoord cell) const
{
    return !embedding.hasHeading() && embedding.position(state) == question.lattice.centre(cell);
}

void QueryParts::tryJoin(const ob::State *state, OffsetCoord cell, bool isStart)
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
    if (isStart ? cache->askMotion(state, scratch_.get()) : cache->askMotion(scratch_.get(), state))
        add(state, cell, isStart);
}

void QueryParts::placeCentre(const ob::State *state, OffsetCoord cell, bool isStart)
{
    embedding.place(scratch_.get(), question.lattice.centre(cell), jointHeading(state, cell, isStart));
}

void QueryParts::add(const ob::State *state, OffsetCoord cell, bool isStart)
{
    (isStart ? starts : joinedGoals).push_back({cell, jointCost(state, cell, isStart), state});
}

double QueryParts::jointCost(const ob::State *state, OffsetCoord cell, bool isStart)
{
    const Point leg = question.lattice.centre(cell) - embedding.position(state);
    if (metric == LengthMetric::Euclidean)
        return leg.norm() / question.lattice.pitch();
    if (metric == LengthMetric::Lattice)
        return latticeNorm(leg, question.lattice);
    const ob::OptimizationObjective &objective = *question.objective;
    if (coincide(state, cell))
        return (isStart ? objective.initialCost(state) : objective.terminalCost(state)).value();
    placeCentre(state, cell, isStart);
    const ob::Cost cost =
        isStart ? objective.combineCosts(objective.initialCost(state), objective.motionCost(state, scratch_.get()))
                : objective.combineCosts(objective.motionCost(scratch_.get(), state), objective.terminalCost(state));
    return safety != nullptr ? cost.value() / unit() : cost.value();
}

}  // namespace seahex
