#pragma once

#include <seahex/search/PrismMotions.h>
#include <seahex/search/PrismMoves.h>
#include <seahex/world/DiveArena.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace seahex
{

/// The motions of a prism lattice that are free in a DiveArena, just those.
///
/// Of each hexagon that is met it remembers how deep its centre is free, and how deep all of it: over hexagons that are
/// free as deep as a motion goes nothing more is asked. Only near the bottom and beside columns that are kept out of is
/// the exact segment asked for. Four bytes a cell.
class PrismWater : public PrismMotions
{
public:
    /// Layout and moves are the lattice's, and must outlive this as it must.
    /// @param bounds  nodes outside are left out
    PrismWater(std::shared_ptr<const DiveArena> arena, const PrismLattice &lattice, const CellLayout &layout,
               const PrismMoves &moves, const Box &bounds);

    Answer judge(const PrismMotion &motion) override;

private:
    static constexpr std::int16_t unknown = -2;
    static constexpr std::int16_t none = -1;

    /// The deepest layer in which the centre of a cell is free.
    int deepest(CellIndex cell);
    /// The deepest layer down to which all of the closed cell is free.
    int safe(CellIndex cell);
    bool isKeptOutOf(const Box &box) const;
    std::int16_t lastLayerAbove(double depth) const;

    std::shared_ptr<const DiveArena> arena_;
    const PrismLattice &lattice_;
    const CellLayout &layout_;
    const PrismMoves &moves_;
    Box bounds_;
    int firstLayer_ = 0;  // that is not above the ceiling
    struct Column
    {
        std::int16_t deepest = unknown;
        std::int16_t safe = unknown;
    };
    std::vector<Column> columns_;
};

}  // namespace seahex
