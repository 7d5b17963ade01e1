#include "seahex/planning/SquareAStar.h"

#include "planning/JumpChoice.h"
#include "planning/ProblemLattice.h"
#include "seahex/planning/PlanarEmbedding.h"

namespace seahex
{

SquareAStar::SquareAStar(const ompl::base::SpaceInformationPtr &si) : LatticeAStar(si, "SquareAStar")
{
    if (PlanarEmbedding(si->getStateSpace().get()).lattice() != nullptr)
        throw ompl::Exception(getName(), "the states of '" + si->getStateSpace()->getName() + "' lie in hexagons");
    declareParam<int>("neighbours", this, &SquareAStar::setNeighbours, &SquareAStar::getNeighbours, "4,8");
}

void SquareAStar::setNeighbours(int neighbours)
{
    if (neighbours != 4 && neighbours != 8)
        throw ompl::Exception(getName(), "neighbours must be 4 or 8, not " + std::to_string(neighbours));
    neighbours_ = neighbours;
    forgetSearch();
}

bool SquareAStar::isOwn(const Lattice &lattice) const
{
    return lattice.squares() != nullptr;
}

Lattice SquareAStar::layLattice(const PlanarEmbedding &embedding, double requestedCellSize) const
{
    return seahex::layLattice<SquareLattice>(embedding, requestedCellSize);
}

JumpChoice SquareAStar::jumpChoice() const
{
    JumpChoice choice;
    choice.neighbours = neighbours_;
    choice.rule = jumpRule();
    return choice;
}

}  // namespace seahex
