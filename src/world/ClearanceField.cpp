#include "seahex/world/ClearanceField.h"

#include <algorithm>
#include <cmath>

namespace seahex
{
namespace
{

/// How far the nearest blocked cell of its own row is from each cell, in columns. Of a row only that one can be the
/// nearest of all, so a cell has to look at one cell a row.
class RowGaps
{
public:
    explicit RowGaps(const Occupancy &occupancy)
        : isHex_(occupancy.lattice().hexagons() != nullptr), rows_(occupancy.layout().rows()),
          width_(occupancy.layout().columns() + 2), gaps_(static_cast<std::size_t>(width_ * (rows_ + 2)), 0)
    {
        const CellLayout &layout = occupancy.layout();
        for (std::int64_t row = 0; row < rows_; ++row)
        {
            const auto rowBegin = static_cast<std::int64_t>(layout.index(OffsetCoord{-1, row}));
            std::uint32_t *gaps = &gaps_[static_cast<std::size_t>((row + 1) * width_)];
            for (std::int64_t i = 1; i < width_; ++i)
                gaps[i] = occupancy.isBlockedAt(static_cast<CellIndex>(rowBegin + i)) ? 0 : gaps[i - 1] + 1;
            for (std::int64_t i = width_ - 2; i >= 0; --i)
                gaps[i] = std::min(gaps[i], gaps[i + 1] + 1);
        }
    }

    /// Along a row, in columns, from the place of a cell to the nearest blocked cell of another row. Rows -1 and rows()
    /// stand for all rows beyond.
    double along(std::int64_t column, std::int64_t row, std::int64_t otherRow) const
    {
        const std::uint32_t *gaps = &gaps_[static_cast<std::size_t>((otherRow + 1) * width_ + column + 1)];
        if (!isHex_ || ((row ^ otherRow) & 1) == 0)
            return gaps[0];
        // a place between two cells: even rows lie half a cell farther east
        return 0.5 + std::min(gaps[0], (row & 1) == 0 ? gaps[1] : gaps[-1]);
    }

private:
    bool isHex_;
    std::int64_t rows_;
    std::int64_t width_;  // with a blocked column on either side
    std::vector<std::uint32_t> gaps_;
};

/// The largest float that is not more than the value.
float roundedDown(double value)
{
    const auto nearest = static_cast<float>(value);
    return static_cast<double>(nearest) > value ? std::nextafter(nearest, 0.0f) : nearest;
}

}  // namespace

ClearanceField::ClearanceField(const Occupancy &occupancy, double limit)
    : lattice_(occupancy.lattice()), layout_(occupancy.layout()), values_(layout_.size(), 0.0f)
{
    const RowGaps gaps(occupancy);
    const double pitch = lattice_.pitch();
    const double rowStep = lattice_.rowStep();
    const double halfHeight = lattice_.halfHeight();
    const OffsetCoord cell{0, 0};  // all cells being alike, this one stands for the nearest
    const Point centre = lattice_.centre(cell);
    for (std::int64_t row = 0; row < layout_.rows(); ++row)
        for (std::int64_t column = 0; column < layout_.columns(); ++column)
        {
            const CellIndex index = layout_.index(OffsetCoord{column, row});
            if (occupancy.isBlockedAt(index))
                continue;
            double best = limit;
            const auto offer = [&](std::int64_t otherRow)
            {
                const Point away(gaps.along(column, row, otherRow) * pitch,
                                 rowStep * static_cast<double>(std::abs(otherRow - row)));
                // no need to measure what the cell's box is too far for
                const double x = std::max(away.x() - 0.5 * pitch, 0.0);
                const double y = std::max(away.y() - halfHeight, 0.0);
                if (x * x + y * y < best * best)
                    best = std::min(best, lattice_.distance(centre + away, cell));
            };
            offer(row);
            for (std::int64_t step = 1; rowStep * static_cast<double>(step) - halfHeight < best; ++step)
            {
                if (row - step >= -1)
                    offer(row - step);
                if (row + step <= layout_.rows())
                    offer(row + step);
                if (row - step < -1 && row + step > layout_.rows())
                    break;
            }
            values_[index] = roundedDown(best);
        }
}

}  // namespace seahex
