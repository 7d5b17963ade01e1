#pragma once

#include <seahex/search/LengthAlgebra.h>
#include <seahex/search/PrismMotions.h>
#include <seahex/search/PrismMoves.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace seahex
{

/// A goal of a search on prisms: a point, and the nodes from which it is reached by a straight leg.
struct PrismGoal
{
    Point3 position;
    std::vector<std::pair<CellIndex, double>> joints;  ///< state, and the length of the leg in pitches
};

/// The nodes of a prism lattice as AStar wants them. State numbers are layer * cells + cell, with the cells of a
/// CellLayout; costs are Euclidean lengths in pitches.
///
/// The bound of a goal g at a node n is |g - n| + c, or 0 if that is more: |.| is the norm of the moves
/// (PrismMoves::norm), c the least of f - |g - j| over the goal's joints j with legs of length f. It is consistent
/// because the norm is, and admissible because |g - n| + c <= |j - n| + |g - j| + c <= |j - n| + f for each joint.
class PrismGraph : public LengthAlgebra
{
public:
    /// Lattice, moves and motions must outlive the graph.
    PrismGraph(const PrismLattice &lattice, const CellLayout &layout, const PrismMoves &moves, PrismMotions &motions,
               const std::vector<PrismGoal> &goals)
        : lattice_(lattice), layout_(layout), cells_(static_cast<CellIndex>(layout.size())), moves_(moves),
          motions_(motions)
    {
        for (const PrismGoal &goal : goals)
        {
            double least = worst();
            for (const auto &[state, length] : goal.joints)
            {
                least = std::min(least, length - moves.norm(goal.position - position(state)));
                const auto known = finishes_.emplace(state, length).first;
                known->second = std::min(known->second, length);
            }
            if (!goal.joints.empty())
                bounds_.emplace_back(goal.position, least);
        }
    }

    CellIndex state(CellIndex cell, int layer) const { return static_cast<CellIndex>(layer) * cells_ + cell; }
    int layerOf(CellIndex state) const { return static_cast<int>(state / cells_); }
    CellIndex cellOf(CellIndex state) const { return state % cells_; }
    Point3 position(CellIndex state) const
    {
        return lattice_.node(toCube(layout_.offset(cellOf(state))), layerOf(state));
    }

    std::size_t size() const { return static_cast<std::size_t>(lattice_.layers()) * cells_; }

    template <class Relax>
    bool expand(CellIndex state, std::uint8_t, Relax &&relax)
    {
        const std::vector<PrismMove> &moves = moves_.all();
        const int layer = layerOf(state);
        const CellIndex cell = cellOf(state);
        // What was relaxed before an interruption stays relaxed.
        std::size_t k = interrupted_ && interrupted_->first == state ? interrupted_->second : 0;
        interrupted_.reset();
        for (; k < moves.size(); ++k)
        {
            const PrismMove &move = moves[k];
            const int toLayer = layer + move.layers;
            if (toLayer < 0 || toLayer >= lattice_.layers())
                continue;
            const CellIndex to = moves_.successor(cell, move);
            switch (motions_.judge({cell, to, layer, toLayer, move.jump}))
            {
                case PrismMotions::Answer::Valid:
                    relax(this->state(to, toLayer), static_cast<std::uint8_t>(k), move.length);
                    break;
                case PrismMotions::Answer::Invalid:
                    break;
                case PrismMotions::Answer::Interrupted:
                    interrupted_ = {state, k};
                    return false;
            }
        }
        return true;
    }

    CellIndex predecessor(CellIndex state, std::uint8_t name) const
    {
        const PrismMove &move = moves_.all()[name];
        return this->state(moves_.predecessor(cellOf(state), move), layerOf(state) - move.layers);
    }

    double bound(CellIndex state) const
    {
        const Point3 p = position(state);
        double best = worst();
        for (const auto &[goal, offset] : bounds_)
            best = std::min(best, moves_.norm(goal - p) + offset);
        return std::max(best, 0.0);
    }

    static bool sharpen(std::uint64_t) { return false; }
    /// The deepest of equal estimates first.
    static double tie(CellIndex, double bound) { return bound; }

    double finish(CellIndex state) const
    {
        const auto found = finishes_.find(state);
        return found == finishes_.end() ? worst() : found->second;
    }

private:
    const PrismLattice &lattice_;
    CellLayout layout_;
    CellIndex cells_;
    const PrismMoves &moves_;
    PrismMotions &motions_;
    std::map<CellIndex, double> finishes_;
    std::vector<std::pair<Point3, double>> bounds_;                 // a goal, and c
    std::optional<std::pair<CellIndex, std::size_t>> interrupted_;  // state, and the move that was not judged
};

}  // namespace seahex
