#include "seahex/planning/HexAStar.h"

#include "planning/JumpChoice.h"
#include "planning/ProblemLattice.h"

namespace seahex
{

HexAStar::HexAStar(const ompl::base::SpaceInformationPtr &si) : LatticeAStar(si, "HexAStar")
{
    declareParam<int>("rings", this, &HexAStar::setRings, &HexAStar::getRings, "1:1:3");
    declareParam<bool>("anytime", this, &HexAStar::setAnytime, &HexAStar::getAnytime, "0,1");
    declareParam<bool>("exact", this, &HexAStar::setExact, &HexAStar::getExact, "0,1");
    declareParam<bool>("all_jumps", this, &HexAStar::setAllJumps, &HexAStar::getAllJumps, "0,1");
}

void HexAStar::setRings(int rings)
{
    if (rings < 1 || rings > 3)
        throw ompl::Exception(getName(), "rings must be 1, 2 or 3, not " + std::to_string(rings));
    rings_ = rings;
    forgetSearch();
}

void HexAStar::setAnytime(bool anytime)
{
    anytime_ = anytime;
    forgetSearch();
}

void HexAStar::setExact(bool exact)
{
    exact_ = exact;
    forgetSearch();
}

void HexAStar::setAllJumps(bool all)
{
    allJumps_ = all;
    forgetSearch();
}

std::optional<HexLattice> HexAStar::lattice() const
{
    const std::optional<Lattice> &lattice = LatticeAStar::lattice();
    return lattice ? std::optional<HexLattice>(*lattice->hexagons()) : std::nullopt;
}

bool HexAStar::isOwn(const Lattice &lattice) const
{
    return lattice.hexagons() != nullptr;
}

Lattice HexAStar::layLattice(const PlanarEmbedding &embedding, double requestedCellSize) const
{
    return seahex::layLattice<HexLattice>(embedding, requestedCellSize);
}

JumpChoice HexAStar::jumpChoice() const
{
    JumpChoice choice;
    choice.rings = rings_;
    choice.allJumps = allJumps_;
    choice.rule = jumpRule();
    return choice;
}

}  // namespace seahex
