#pragma once

#include <seahex/search/LengthTree.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace seahex
{

/// The shortest chain of ring jumps, again and again while start, goal and cells change: as short as that of a new
/// LengthSearch, at what the change is worth.
///
/// It keeps a LengthTree from the goal, whose branches lead from wherever the vessel gets to. A start further along the
/// route, or beside it, costs nothing; cells that are blocked elsewhere next to nothing; a hazard on the route, what
/// lies behind it as seen from the goal: the nearer to the vessel, the less. A goal that moves needs a tree from the
/// start, which takes a search the first time and little from then on, until the start moves too;
/// prepareForGoals() makes it in advance.
///
/// Memory: that of one LengthTree, of two where goals move. One thread at a time.
class Replanner
{
public:
    /// @param occupancy  of hexagons
    /// @param rings  1, 2 or 3
    /// @throws std::length_error as LengthTree
    Replanner(std::shared_ptr<const Occupancy> occupancy, int rings);

    /// Takes another occupancy of the same lattice in the place of the one before: a hazard was reported, or is gone.
    /// @throws std::length_error if the lattice has another size
    void setOccupancy(const std::shared_ptr<const Occupancy> &occupancy);

    /// Finds the shortest path between two cells; see LengthTree::growTo().
    SearchStatus plan(HexCoord start, HexCoord goal, const std::function<bool()> &stop = {});
    /// With time to spare, after plan(): makes another goal as cheap as another start is.
    SearchStatus prepareForGoals(const std::function<bool()> &stop = {});

    /// What the last plan() found, in pitches; infinite if nothing. Not to be asked between setOccupancy() and plan().
    double length() const;
    /// Its cells from start to goal; empty if nothing.
    std::vector<CellIndex> path() const;

private:
    struct Ends
    {
        HexCoord start;
        HexCoord goal;
    };

    bool useTreeFor(HexCoord start, HexCoord goal);
    void plantAtStart(HexCoord start);

    std::shared_ptr<const Occupancy> occupancy_;
    int rings_;
    LengthTree fromGoal_;
    std::unique_ptr<LengthTree> fromStart_;  // if a goal has moved
    std::optional<Ends> ends_;               // of the last plan()
    bool isFromStart_ = false;               // which tree holds its answer
    bool isFound_ = false;
};

}  // namespace seahex
