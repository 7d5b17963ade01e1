#include "DeepWater.h"

#include <algorithm>
#include <utility>

namespace demos
{
namespace
{

/// Numbers the waters of a grid of cells.
class Filler
{
public:
    Filler(const seahex::Bathymetry &seabed, double leastDepthM, std::vector<std::uint32_t> &water)
        : seabed_(seabed), leastDepthM_(leastDepthM), water_(water), columns_(seabed.grid().columns() - 1),
          rows_(seabed.grid().rows() - 1)
    {
    }

    /// Fills the water that a cell belongs to.
    /// @return its cells; 0 if the cell is not deep enough or was filled before
    std::int64_t fill(std::int64_t column, std::int64_t row, std::uint32_t number)
    {
        std::int64_t count = 0;
        enter(column, row, number);
        while (!open_.empty())
        {
            const auto [c, r] = open_.back();
            open_.pop_back();
            ++count;
            enter(c - 1, r, number);
            enter(c + 1, r, number);
            enter(c, r - 1, number);
            enter(c, r + 1, number);
        }
        return count;
    }

private:
    void enter(std::int64_t column, std::int64_t row, std::uint32_t number)
    {
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_ || !isDeep(column, row))
            return;
        std::uint32_t &water = water_[static_cast<std::size_t>(row * columns_ + column)];
        if (water != 0)
            return;
        water = number;
        open_.emplace_back(column, row);
    }

    bool isDeep(std::int64_t column, std::int64_t row) const
    {
        const auto [north, east] = std::pair(row + 1, column + 1);
        return std::min({seabed_.nodeDepth(column, row), seabed_.nodeDepth(east, row), seabed_.nodeDepth(column, north),
                         seabed_.nodeDepth(east, north)}) >= leastDepthM_;
    }

    const seahex::Bathymetry &seabed_;
    double leastDepthM_;
    std::vector<std::uint32_t> &water_;
    std::int64_t columns_;
    std::int64_t rows_;
    std::vector<std::pair<std::int64_t, std::int64_t>> open_;
};

}  // namespace

DeepWater::DeepWater(const seahex::Bathymetry &seabed, double leastDepthM)
    : grid_(seabed.grid()), water_(static_cast<std::size_t>((grid_.columns() - 1) * (grid_.rows() - 1)), 0)
{
    Filler filler(seabed, leastDepthM, water_);
    std::uint32_t next = 1;
    for (std::int64_t row = 0; row + 1 < grid_.rows(); ++row)
        for (std::int64_t column = 0; column + 1 < grid_.columns(); ++column)
        {
            const std::int64_t count = filler.fill(column, row, next);
            if (count > cellCount_)
            {
                cellCount_ = count;
                largest_ = next;
            }
            next += count > 0 ? 1 : 0;
        }
}

bool DeepWater::contains(const seahex::Point &p) const
{
    if (largest_ == 0 || !grid_.bounds().contains(p))
        return false;
    const seahex::Point steps = grid_.steps(p);
    const auto column = std::min(static_cast<std::int64_t>(steps.x()), grid_.columns() - 2);
    const auto row = std::min(static_cast<std::int64_t>(steps.y()), grid_.rows() - 2);
    return water_[static_cast<std::size_t>(row * (grid_.columns() - 1) + column)] == largest_;
}

}  // namespace demos
