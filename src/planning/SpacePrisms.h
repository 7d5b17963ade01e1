#pragma once

#include "planning/SpaceJudge.h"
#include "seahex/search/PrismMotions.h"
#include "seahex/search/PrismMoves.h"

#include <cstdint>
#include <vector>

namespace seahex
{

/// The motions of a prism lattice that a problem's own code holds valid: each node is asked for once, each motion in
/// its direction, and only where both its nodes are valid. Looks at the termination condition as SpaceJudge does.
class SpacePrisms : public PrismMotions
{
public:
    /// Lattice and layout must outlive this.
    SpacePrisms(const PrismLattice &lattice, const CellLayout &layout)
        : lattice_(lattice), layout_(layout),
          nodes_(layout.size() * static_cast<std::size_t>(lattice.layers()), unknown)
    {
    }

    /// Whom to ask from now on; must live as long as questions are asked.
    void ask(SpaceJudge &judge) { judge_ = &judge; }

    Answer judge(const PrismMotion &motion) override
    {
        const HexCoord to = layout_.cell(motion.to);
        if (!lattice_.plane().contains(to))
            return Answer::Invalid;
        const Point3 place = lattice_.node(to, motion.toLayer);
        std::uint8_t &known = nodes_[static_cast<std::size_t>(motion.toLayer) * layout_.size() + motion.to];
        if (known == unknown)
        {
            const LegJudge::Answer answer = judge_->judgePlace(place);
            if (answer == LegJudge::Answer::Interrupted)
                return Answer::Interrupted;
            known = answer == LegJudge::Answer::Valid ? valid : invalid;
        }
        if (known == invalid)
            return Answer::Invalid;
        switch (judge_->judge(lattice_.node(layout_.cell(motion.from), motion.fromLayer), place))
        {
            case LegJudge::Answer::Valid:
                return Answer::Valid;
            case LegJudge::Answer::Invalid:
                return Answer::Invalid;
            case LegJudge::Answer::Interrupted:
                break;
        }
        return Answer::Interrupted;
    }

private:
    static constexpr std::uint8_t unknown = 0;
    static constexpr std::uint8_t valid = 1;
    static constexpr std::uint8_t invalid = 2;

    const PrismLattice &lattice_;
    const CellLayout &layout_;
    std::vector<std::uint8_t> nodes_;
    SpaceJudge *judge_ = nullptr;
};

}  // namespace seahex
