#include "seahex/world/Clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seahex
{
namespace
{

/// Finds the nearest cell whose bit, xored with `flip`, is set.
class NearestCell
{
public:
    NearestCell(const Occupancy &occupancy, const Point &p, bool blocked)
        : occupancy_(occupancy), lattice_(occupancy.lattice()), p_(p), flip_(blocked ? 0 : ~std::uint64_t{0})
    {
    }

    std::optional<CellDistance> find()
    {
        // Rows -1 and rows() stand for all rows beyond: their cells are blocked and nearer.
        const std::int64_t top = -1;
        const std::int64_t bottom = lattice_.rows();
        const std::int64_t start = std::clamp(lattice_.cellAt(p_).row, top, bottom);
        for (std::int64_t step = 0;; ++step)
        {
            const bool above = start - step >= top && tryRow(start - step);
            const bool below = step > 0 && start + step <= bottom && tryRow(start + step);
            if (!above && !below && step > 0)
                return best_;
        }
    }

private:
    /// @return false if no cell of this row, or of a row farther away on this side, can be nearer than the best so far
    bool tryRow(std::int64_t row)
    {
        const double centreY = lattice_.centre({0, row}).y();
        const double gap = std::abs(p_.y() - centreY) - lattice_.halfHeight();
        if (best_ && gap > best_->distance)
            return false;
        const CellLayout &layout = occupancy_.layout();
        const auto rowBegin = static_cast<std::int64_t>(layout.index(OffsetCoord{-CellLayout::frame, row}));
        const double first = lattice_.firstColumn(row);
        const double column = std::floor((p_.x() - lattice_.northWest().x()) / lattice_.pitch() - first);
        const auto position = static_cast<std::int64_t>(
            std::clamp(column + static_cast<double>(CellLayout::frame), 0.0, static_cast<double>(layout.stride() - 1)));
        offer(row, westward(rowBegin, position));
        offer(row, eastward(rowBegin, layout.stride(), std::min(position + 1, layout.stride() - 1)));
        return true;
    }

    void offer(std::int64_t row, std::int64_t position)
    {
        if (position < 0)
            return;
        const OffsetCoord cell{position - CellLayout::frame, row};
        const double distance = lattice_.distance(p_, cell);
        if (!best_ || distance < best_->distance)
            best_ = CellDistance{cell, distance};
    }

    std::uint64_t word(std::int64_t index) const { return occupancy_.words()[static_cast<std::size_t>(index)] ^ flip_; }

    /// Position in the row of the last set bit at or before `position`, -1 if there is none.
    std::int64_t westward(std::int64_t rowBegin, std::int64_t position) const
    {
        std::int64_t w = position >> 6;
        std::uint64_t bits = word((rowBegin >> 6) + w) & (~std::uint64_t{0} >> (63 - (position & 63)));
        while (bits == 0 && w > 0)
            bits = word((rowBegin >> 6) + --w);
        return bits == 0 ? -1 : (w << 6) + 63 - __builtin_clzll(bits);
    }

    /// Position in the row of the first set bit at or after `position`, -1 if there is none.
    std::int64_t eastward(std::int64_t rowBegin, std::int64_t stride, std::int64_t position) const
    {
        std::int64_t w = position >> 6;
        std::uint64_t bits = word((rowBegin >> 6) + w) & (~std::uint64_t{0} << (position & 63));
        while (bits == 0 && w + 1 < stride >> 6)
            bits = word((rowBegin >> 6) + ++w);
        return bits == 0 ? -1 : (w << 6) + __builtin_ctzll(bits);
    }

    const Occupancy &occupancy_;
    const Lattice &lattice_;
    Point p_;
    std::uint64_t flip_;
    std::optional<CellDistance> best_;
};

}  // namespace

CellDistance nearestBlocked(const Occupancy &occupancy, const Point &p)
{
    const OffsetCoord cell = occupancy.lattice().cellAt(p);
    if (!occupancy.lattice().contains(cell))
        return {cell, 0.0};
    return *NearestCell(occupancy, p, true).find();
}

std::optional<CellDistance> nearestFree(const Occupancy &occupancy, const Point &p)
{
    return NearestCell(occupancy, p, false).find();
}

double signedClearance(const Occupancy &occupancy, const Point &p)
{
    if (occupancy.isFree(occupancy.lattice().cellAt(p)))
        return nearestBlocked(occupancy, p).distance;
    const std::optional<CellDistance> free = nearestFree(occupancy, p);
    return free ? -free->distance : -std::numeric_limits<double>::infinity();
}

}  // namespace seahex
