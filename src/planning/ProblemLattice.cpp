#include "planning/ProblemLattice.h"

#include "seahex/planning/OccupancyMotionValidator.h"
#include "seahex/planning/OccupancyValidityChecker.h"
#include "seahex/world/CellBits.h"

#include <ompl/util/Exception.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <utility>

namespace ob = ompl::base;

namespace seahex
{
namespace
{

constexpr std::int64_t mostCells = 1000000;  // of a lattice of our own

/// The object as exactly this class; nullptr if it is of another, derived ones included.
template <class Class, class Base>
const Class *exactly(const Base *object)
{
    return object != nullptr && typeid(*object) == typeid(Class) ? static_cast<const Class *>(object) : nullptr;
}

/// The tolerance of points on cells grows with their coordinates. True where it is small against a cell, so that the
/// motion validator and the integers of the lattice say the same.
bool isExact(const Lattice &lattice)
{
    const Box box = lattice.bounds();
    constexpr double farthest = 1e7;  // pitches: a tolerance of a 100th
    return box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff() <= farthest * lattice.pitch();
}

}  // namespace

void requireAskable(const Lattice &lattice)
{
    constexpr std::int64_t mostAskable = 10000000;
    if (lattice.cellCount() > mostAskable)
        throw ompl::Exception("seahex", "the lattice has " + std::to_string(lattice.cellCount()) +
                                            " cells; where the problem's own checker is asked, at most " +
                                            std::to_string(mostAskable) + " are allowed");
}

std::shared_ptr<const Occupancy> sharedOccupancy(const ob::SpaceInformation &si)
{
    const auto *checker = exactly<OccupancyValidityChecker>(si.getStateValidityChecker().get());
    const auto *validator = exactly<OccupancyMotionValidator>(si.getMotionValidator().get());
    if (checker == nullptr || validator == nullptr || checker->occupancy() != validator->occupancy())
        return nullptr;
    if (!isExact(checker->occupancy()->lattice()))
        return nullptr;
    const HexLattice *cells = PlanarEmbedding(si.getStateSpace().get()).lattice();
    if (cells != nullptr && checker->occupancy()->lattice() != *cells)
        return nullptr;
    return checker->occupancy();
}

std::shared_ptr<const Occupancy> withinBounds(const std::shared_ptr<const Occupancy> &occupancy, const Box &box)
{
    const Lattice &lattice = occupancy->lattice();
    const Box whole = lattice.bounds();
    if (box.contains(whole.min) && box.contains(whole.max))
        return occupancy;
    const auto isOutside = [&](std::int64_t column, std::int64_t row)
    {
        return !box.contains(lattice.centre({column, row}));
    };
    CellBits bits(occupancy->layout());
    const CellWords &words = occupancy->words();
    bits.words().assign(words.begin(), words.end());
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
    {
        std::int64_t first = 0;
        std::int64_t last = lattice.columns() - 1;
        while (first <= last && isOutside(first, row))
            ++first;
        while (last >= first && isOutside(last, row))
            --last;
        bits.setSpan(row, 0, first - 1);
        bits.setSpan(row, last + 1, lattice.columns() - 1);
    }
    if (std::equal(words.begin(), words.end(), bits.words().begin()))
        return occupancy;
    if (lattice.hexagons() != nullptr)
        return std::make_shared<const HexOccupancy>(*lattice.hexagons(), occupancy->layout(), std::move(bits.words()));
    return std::make_shared<const Occupancy>(lattice, occupancy->layout(), std::move(bits.words()));
}

template <class KnownLattice>
KnownLattice layLattice(const PlanarEmbedding &embedding, double requestedCellSize)
{
    if constexpr (std::is_same_v<KnownLattice, HexLattice>)
        if (embedding.lattice() != nullptr)
        {
            requireAskable(*embedding.lattice());
            return *embedding.lattice();
        }
    const Box bounds = embedding.bounds();
    const Point extent = bounds.max - bounds.min;
    const double pitch = requestedCellSize > 0.0 ? requestedCellSize : extent.maxCoeff() / 200.0;
    // Estimated first: the number of cells of a tiny pitch is beyond any lattice.
    double cells = (extent.x() / pitch) * (extent.y() / pitch);
    if (cells <= 2.0 * static_cast<double>(mostCells))
    {
        KnownLattice lattice = KnownLattice::covering(bounds, pitch);
        if (lattice.cellCount() <= mostCells)
            return lattice;
        cells = static_cast<double>(lattice.cellCount());
    }
    throw ompl::Exception("seahex", "a cell size of " + std::to_string(pitch) + " makes about " +
                                        std::to_string(cells) + " cells; at most " + std::to_string(mostCells) +
                                        " are allowed");
}

template HexLattice layLattice<HexLattice>(const PlanarEmbedding &, double);
template SquareLattice layLattice<SquareLattice>(const PlanarEmbedding &, double);

}  // namespace seahex
