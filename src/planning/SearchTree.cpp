#include "planning/SearchTree.h"

#include "seahex/planning/LatticeAStar.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex
{
namespace
{

ob::PlannerDataVertex tagged(const ob::State *state, PlannerDataTag tag)
{
    return {state, static_cast<int>(tag)};
}

}  // namespace

std::size_t SearchTree::Hash::operator()(const VertexName &name) const
{
    // a lattice has fewer than 2^32 cells, and a cell fewer than 256 headings
    const auto row = static_cast<std::uint64_t>(name.cell.row);
    const auto column = static_cast<std::uint64_t>(name.cell.column) & 0xffffffffU;
    return std::hash<std::uint64_t>()((row << 32) ^ (column << 8) ^ name.way);
}

SearchTree::SearchTree(ob::SpaceInformationPtr si) : si_(std::move(si)), embedding_(si_->getStateSpace().get()) {}

void SearchTree::clear()
{
    for (const auto &entry : states_)
        si_->freeState(entry.second);
    states_.clear();
    ends_.clear();
    paths_.clear();
}

const ob::State *SearchTree::find(const VertexName &name) const
{
    const auto end = ends_.find(name);
    if (end != ends_.end())
        return end->second;
    const auto state = states_.find(name);
    return state == states_.end() ? nullptr : state->second;
}

const ob::State *SearchTree::findEqual(OffsetCoord cell, const ob::State *state) const
{
    for (std::size_t way = 0; way < ways_; ++way)
        if (const ob::State *known = find({cell, way}))
            if (si_->getStateSpace()->equalStates(known, state))
                return known;
    return nullptr;
}

const ob::State *SearchTree::stateOf(const TreeVertex &vertex)
{
    ways_ = std::max(ways_, vertex.name.way + 1);
    if (vertex.isStart)
        ends_[vertex.name] = vertex.start;
    else if (ends_.count(vertex.name) == 0)
    {
        ob::State *&state = states_[vertex.name];
        if (state == nullptr)
            state = si_->allocState();
        embedding_.place(state, vertex.position, vertex.heading);
    }
    return find(vertex.name);
}

void SearchTree::write(const LatticeQuery &query, const ob::OptimizationObjective &objective, ob::PlannerData &data)
{
    query.forEachReachedGoal(
        [&](const GoalVertex &vertex)
        {
            data.addGoalVertex(tagged(vertex.goal, PlannerDataTag::Waiting));
            if (vertex.isCentre)
                ends_[vertex.from] = vertex.goal;
        });
    // Parents may come later than their children in the order of cells, so all vertices first.
    query.forEachVertex(
        [&](const TreeVertex &vertex)
        {
            const PlannerDataTag tag = vertex.isExpanded ? PlannerDataTag::Expanded : PlannerDataTag::Waiting;
            const ob::State *state = stateOf(vertex);
            data.addVertex(tagged(state, tag));
            data.tagState(state, static_cast<int>(tag));
            if (vertex.start != nullptr)
                data.addStartVertex(tagged(vertex.start, PlannerDataTag::Expanded));
        });
    const auto join = [&](const ob::State *from, const ob::State *to)
    {
        if (from != to)
            data.addEdge(data.vertexIndex(ob::PlannerDataVertex(from)), data.vertexIndex(ob::PlannerDataVertex(to)),
                         ob::PlannerDataEdge(), objective.motionCost(from, to));
    };
    query.forEachVertex([&](const TreeVertex &vertex)
                        { join(vertex.parent ? find(*vertex.parent) : vertex.start, find(vertex.name)); });
    query.forEachReachedGoal([&](const GoalVertex &vertex) { join(find(vertex.from), vertex.goal); });
}

void SearchTree::write(const std::shared_ptr<og::PathGeometric> &path, const EndStates &ends, const Lattice &lattice,
                       const ob::OptimizationObjective &objective, ob::PlannerData &data)
{
    if (paths_.empty() || paths_.back() != path)
        paths_.push_back(path);
    const ob::StateSpace &space = *si_->getStateSpace();
    const auto equalOf = [&](const std::vector<ob::State *> &states, const ob::State *state)
    {
        const auto equal = std::find_if(states.begin(), states.end(),
                                        [&](const ob::State *end) { return space.equalStates(end, state); });
        return equal == states.end() ? state : *equal;
    };
    const auto vertexOf = [&](std::size_t i)
    {
        const ob::State *state = path->getState(static_cast<unsigned int>(i));
        if (i == 0)
            return equalOf(ends.starts(), state);
        if (i + 1 == path->getStateCount())
            return equalOf(ends.goals(), state);
        const ob::State *centre = findEqual(lattice.cellAt(embedding_.position(state)), state);
        return centre != nullptr ? centre : state;
    };
    const ob::State *before = nullptr;
    for (std::size_t i = 0; i < path->getStateCount(); ++i)
    {
        const ob::State *state = vertexOf(i);
        const ob::PlannerDataVertex vertex = tagged(state, PlannerDataTag::Solution);
        if (i == 0)
            data.addStartVertex(vertex);
        if (i + 1 == path->getStateCount())
            data.addGoalVertex(vertex);
        data.addVertex(vertex);
        data.tagState(state, static_cast<int>(PlannerDataTag::Solution));
        if (before != nullptr && before != state)
            data.addEdge(data.vertexIndex(ob::PlannerDataVertex(before)), data.vertexIndex(vertex),
                         ob::PlannerDataEdge(), objective.motionCost(before, state));
        before = state;
    }
}

}  // namespace seahex
