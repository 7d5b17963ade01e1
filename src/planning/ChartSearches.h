#pragma once

#include "seahex/search/CoarseSearch.h"
#include "seahex/search/JumpPointSearch.h"
#include "seahex/search/LengthSearch.h"
#include "seahex/search/TautSearch.h"
#include "seahex/world/CoarseOccupancy.h"

#include <memory>
#include <utility>
#include <vector>

namespace seahex
{

/// The searches by length that a planner makes on the hexagons of a chart, kept from one problem to the next with all
/// their memory.
class ChartSearches
{
public:
    /// Makes large cells and rays, which takes a few milliseconds for a million cells.
    explicit ChartSearches(std::shared_ptr<const HexOccupancy> occupancy)
        : occupancy_(std::move(occupancy)), coarse_(coarseOccupancies(*occupancy_)), cells_(*occupancy_, 3),
          steps_(*occupancy_), taut_(*occupancy_)
    {
        constexpr std::size_t fewCells = std::size_t{1} << 23;  // 32 MB
        if (occupancy_->layout().size() <= fewCells)
            steps_.takeMemory();
        for (const auto &level : coarse_)
            largeCells_.push_back(std::make_unique<CoarseSearch>(*occupancy_, *level));
    }

    const std::shared_ptr<const HexOccupancy> &occupancy() const { return occupancy_; }

    LengthSearch &cells() { return cells_; }
    /// One ring only, and sooner.
    JumpPointSearch &steps() { return steps_; }
    TautSearch &taut() { return taut_; }

    /// From the smallest of the large cells to the largest; each twice as wide as the one before.
    std::size_t levels() const { return largeCells_.size(); }
    CoarseSearch &largeCells(std::size_t level) { return *largeCells_[level]; }

private:
    std::shared_ptr<const HexOccupancy> occupancy_;
    std::vector<std::shared_ptr<const CoarseOccupancy>> coarse_;
    LengthSearch cells_;
    JumpPointSearch steps_;
    TautSearch taut_;
    std::vector<std::unique_ptr<CoarseSearch>> largeCells_;
};

}  // namespace seahex
