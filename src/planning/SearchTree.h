#pragma once

#include "planning/EndStates.h"
#include "planning/LatticeQuery.h"
#include "seahex/planning/PlanarEmbedding.h"

#include <ompl/base/PlannerData.h>

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace seahex
{

/// What a lattice planner found out, as PlannerData: a vertex for every cell that was reached (for every heading with
/// which it was, where the search tells them apart), an edge for every jump of the search tree, the joints of starts
/// and goals, and the path.
///
/// PlannerData knows vertices by the address of their state, so the states live here and stay where they are until
/// clear(). Memory: a state and about 100 bytes a cell.
class SearchTree
{
public:
    explicit SearchTree(ompl::base::SpaceInformationPtr si);
    ~SearchTree() { clear(); }
    SearchTree(const SearchTree &) = delete;
    SearchTree &operator=(const SearchTree &) = delete;

    /// Adds the tree; the starts of the problem are its start vertices, the goals its goal vertices.
    void write(const LatticeQuery &query, const ompl::base::OptimizationObjective &objective,
               ompl::base::PlannerData &data);

    /// Adds a path and keeps it, as its states are vertices; those that are vertices already are not added again.
    /// @param ends  the starts and goals of the problem
    void write(const std::shared_ptr<ompl::geometric::PathGeometric> &path, const EndStates &ends,
               const Lattice &lattice, const ompl::base::OptimizationObjective &objective,
               ompl::base::PlannerData &data);

    void clear();

private:
    struct Hash
    {
        std::size_t operator()(const VertexName &name) const;
    };

    ompl::base::SpaceInformationPtr si_;
    PlanarEmbedding embedding_;
    const ompl::base::State *stateOf(const TreeVertex &vertex);
    const ompl::base::State *find(const VertexName &name) const;
    const ompl::base::State *findEqual(OffsetCoord cell, const ompl::base::State *state) const;

    std::vector<std::shared_ptr<ompl::geometric::PathGeometric>> paths_;
    std::unordered_map<VertexName, ompl::base::State *, Hash> states_;
    std::unordered_map<VertexName, const ompl::base::State *, Hash> ends_;  // starts and goals that are centres
    std::size_t ways_ = 1;                                                  // of the vertices of a cell
};

}  // namespace seahex
