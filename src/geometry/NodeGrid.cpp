#include "seahex/geometry/NodeGrid.h"

#include <stdexcept>
#include <string>

namespace seahex
{

NodeGrid::NodeGrid(const Point &southWest, const Point &spacing, std::int64_t columns, std::int64_t rows)
    : southWest_(southWest), spacing_(spacing), columns_(columns), rows_(rows),
      lastSteps_(static_cast<double>(columns - 1), static_cast<double>(rows - 1)), bounds_{southWest, southWest}
{
    if (columns < 2 || rows < 2)
        throw std::domain_error("a grid of " + std::to_string(columns) + " x " + std::to_string(rows) +
                                " nodes has no cell: 2 x 2 are the least");
    if (columns > INT64_C(0x7fffffff) || rows > INT64_C(0x7fffffff))
        throw std::domain_error("a grid of " + std::to_string(columns) + " x " + std::to_string(rows) +
                                " nodes is too large");
    bounds_.max = node(columns - 1, rows - 1);
    if (!bounds_.max.allFinite() || !southWest.allFinite() || !(spacing.minCoeff() > 0.0))
        throw std::domain_error("a grid's place and spacing must be finite, and the spacing positive");
    const Point first = node(1, 1);
    const Point last = node(columns - 2, rows - 2);
    if (!((first - southWest).minCoeff() > 0.0 && (bounds_.max - last).minCoeff() > 0.0))
        throw std::domain_error("the nodes of a grid are too close together for where they lie");
}

}  // namespace seahex
