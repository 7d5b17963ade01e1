#pragma once

#include "Method.h"

#include <seahex/chart/ChartArena.h>
#include <seahex/geometry/CellLayout.h>
#include <seahex/search/SearchCounters.h>
#include <seahex/world/Occupancy.h>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace reproduce_papers
{

/// What a method found.
struct Answer
{
    seahex::Route path;  ///< start, centres, goal
    seahex::SearchCounters counters;
    double searchMs = 0.0;
    std::vector<seahex::CellIndex> expanded;  ///< in their order, if asked for
};

/// One water on the lattices that are compared: hexagons of a pitch, squares of the same pitch (equal spacing of
/// neighbours) and squares of the same area. All are filled from the same hazards with the same rule, and OMPL plans on
/// each through the same validity checker and motion validator.
///
/// plan() may be called from one thread at a time; make a Sea for each.
class Sea
{
public:
    /// @param squares  of equal spacing; the squares of equal area cover the same box
    Sea(const seahex::ChartArena &arena, const seahex::HexLattice &hexagons, const seahex::SquareLattice &squares);

    const seahex::Occupancy &occupancy(Cells cells) const { return *grounds_[index(cells)].occupancy; }
    std::shared_ptr<const seahex::Occupancy> sharedOccupancy(Cells cells) const
    {
        return grounds_[index(cells)].occupancy;
    }

    /// Plans from start to goal with HexAStar or SquareAStar: one search, neither anytime nor smoothed.
    /// @return empty if there is no path on these cells
    std::optional<Answer> plan(const Method &method, const seahex::Point &start, const seahex::Point &goal,
                               bool isTraced = false) const;

private:
    struct Ground
    {
        std::shared_ptr<const seahex::Occupancy> occupancy;
        ompl::base::SpaceInformationPtr si;
        std::map<Cost, ompl::base::OptimizationObjectivePtr> objectives;
    };

    static std::size_t index(Cells cells) { return static_cast<std::size_t>(cells); }
    static Ground makeGround(std::shared_ptr<const seahex::Occupancy> occupancy);

    std::array<Ground, 3> grounds_;
};

/// Edge of the square that has the area of a hexagon of this pitch.
double edgeOfEqualArea(double pitch);

}  // namespace reproduce_papers
