#include "seahex/search/PrismWater.h"

#include <algorithm>
#include <cmath>

namespace seahex
{
namespace
{

constexpr double inHandM = 1e-6;  // for the rounding of positions on the edge of a cell

}  // namespace

PrismWater::PrismWater(std::shared_ptr<const DiveArena> arena, const PrismLattice &lattice, const CellLayout &layout,
                       const PrismMoves &moves, const Box &bounds)
    : arena_(std::move(arena)), lattice_(lattice), layout_(layout), moves_(moves), bounds_(bounds),
      columns_(layout.size())
{
    while (firstLayer_ < lattice.layers() && lattice.depth(firstLayer_) < arena_->limits().ceilingM)
        ++firstLayer_;
}

PrismMotions::Answer PrismWater::judge(const PrismMotion &motion)
{
    if (motion.toLayer < firstLayer_ || motion.toLayer > deepest(motion.to))
        return Answer::Invalid;
    if (motion.jump == PrismMove::vertical)
        return Answer::Valid;  // as free as its ends
    const int layer = std::max(motion.fromLayer, motion.toLayer);
    const Jumps &jumps = moves_.jumps();
    const Jump &jump = jumps.from(jumps.parity(motion.from))[motion.jump];
    bool isSafe = layer <= safe(motion.from);
    for (std::uint16_t t = jump.firstTouch; isSafe && t < jump.endTouch; ++t)
        isSafe = layer <= safe(static_cast<CellIndex>(static_cast<std::int64_t>(motion.from) + jumps.touched()[t]));
    if (isSafe)
        return Answer::Valid;
    const Point3 from = lattice_.node(layout_.cell(motion.from), motion.fromLayer);
    const Point3 to = lattice_.node(layout_.cell(motion.to), motion.toLayer);
    return arena_->isFree(from, to) ? Answer::Valid : Answer::Invalid;
}

std::int16_t PrismWater::lastLayerAbove(double depth) const
{
    const double layer = std::floor((depth - lattice_.top()) / lattice_.thickness());
    if (!(layer >= 0.0))
        return none;
    return static_cast<std::int16_t>(std::min(layer, static_cast<double>(lattice_.layers() - 1)));
}

int PrismWater::deepest(CellIndex cell)
{
    std::int16_t &known = columns_[cell].deepest;
    if (known != unknown)
        return known;
    known = none;
    const HexCoord place = layout_.cell(cell);
    const Point centre = lattice_.plane().centre(place);
    if (!lattice_.plane().contains(place) || !bounds_.contains(centre))
        return none;
    const DiveLimits &limits = arena_->limits();
    const double depth = arena_->seabed()->depthAt(centre) - limits.clearanceM - DiveArena::roundingM;
    // as isFree() rounds it
    known = lastLayerAbove(std::min(depth, limits.deepestM) + inHandM);
    while (known >= firstLayer_ && !arena_->isFree(lattice_.node(place, known)))
        known = arena_->isFree(lattice_.node(place, firstLayer_)) ? static_cast<std::int16_t>(known - 1) : none;
    return known;
}

int PrismWater::safe(CellIndex cell)
{
    std::int16_t &known = columns_[cell].safe;
    if (known != unknown)
        return known;
    const std::array<Point, 6> corners = lattice_.plane().corners(layout_.cell(cell));
    Box box{corners[0], corners[0]};
    for (const Point &corner : corners)
    {
        box.min = box.min.cwiseMin(corner);
        box.max = box.max.cwiseMax(corner);
    }
    known = none;
    if (isKeptOutOf(box))
        return none;
    const DiveLimits &limits = arena_->limits();
    const double depth = arena_->seabed()->leastDepth(std::vector<Point>(corners.begin(), corners.end())) -
                         limits.clearanceM - DiveArena::roundingM - inHandM;
    known = lastLayerAbove(std::min(depth, limits.deepestM));
    return known;
}

/// Is a cell blocked that the box may touch? Rather yes than no: the cells of its corners, one more each way, are all
/// between.
bool PrismWater::isKeptOutOf(const Box &box) const
{
    if (arena_->keepOut() == nullptr)
        return false;
    const Occupancy &occupancy = *arena_->keepOut();
    const OffsetCoord first = occupancy.lattice().cellAt(Point(box.min.x(), box.max.y()));
    const OffsetCoord last = occupancy.lattice().cellAt(Point(box.max.x(), box.min.y()));
    for (std::int64_t row = first.row - 1; row <= last.row + 1; ++row)
        for (std::int64_t column = first.column - 1; column <= last.column + 1; ++column)
            if (occupancy.isBlocked({column, row}))
                return true;
    return false;
}

}  // namespace seahex
