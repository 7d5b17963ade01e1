#pragma once

#include <seahex/geometry/HexLattice.h>
#include <seahex/planning/LatticeAStar.h>

#include <optional>

namespace seahex
{

/// Anytime A* on a lattice of hexagons with ring expansion [Cheng2020], for problems in R^2, SE(2) and HexStateSpace;
/// see LatticeAStar for all that it does. In a HexStateSpace the lattice is the space's.
class HexAStar : public LatticeAStar
{
public:
    /// @throws ompl::Exception if the space is neither R^2 nor SE(2) nor a HexStateSpace
    explicit HexAStar(const ompl::base::SpaceInformationPtr &si);

    /// 1, 2 or 3 rings: 6, 18 or 36 successors; 3 by default. @throws ompl::Exception otherwise
    void setRings(int rings);
    int getRings() const { return rings_; }

    /// Search in large cells or with one ring before the search with more, for an early answer. On by default.
    void setAnytime(bool anytime);
    bool getAnytime() const { return anytime_; }

    /// Where it can be done (LatticeAStar, Answers; smoothing must be on), go on to the shortest of all valid paths,
    /// not only those of the lattice, and prove it: no valid path is shorter than the one found by more than two
    /// millionths of its length and of the pitch. Where the space's bounds leave out free cells, the path is the
    /// shortest through the others, and nothing is proven. On by default.
    void setExact(bool exact);
    bool getExact() const { return exact_; }

    /// Try every successor of a ring, also those that repeat shorter collinear jumps (JumpSet::All). Only matters where
    /// the objective is a length and jumps are safe; all are tried elsewhere.
    void setAllJumps(bool all);
    bool getAllJumps() const { return allJumps_; }

    /// The lattice in use; empty before setup().
    std::optional<HexLattice> lattice() const;

protected:
    bool isOwn(const Lattice &lattice) const override;
    Lattice layLattice(const PlanarEmbedding &embedding, double requestedCellSize) const override;
    JumpChoice jumpChoice() const override;
    bool searchesTwice() const override { return anytime_; }
    bool isExact() const override { return exact_; }

private:
    int rings_ = 3;
    bool anytime_ = true;
    bool exact_ = true;
    bool allJumps_ = false;
};

}  // namespace seahex
