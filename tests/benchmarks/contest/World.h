#pragma once

#include "contest/Contender.h"

#include <seahex/geometry/Shape.h>

#include <memory>
#include <string>
#include <vector>

namespace seahex::contest
{

/// Cells to search, and the polygons that they were filled from.
struct World
{
    std::string name;
    std::string what;  ///< one line for people
    std::shared_ptr<const HexOccupancy> occupancy;
    std::vector<Shape> land;  ///< in the lattice's frame
    std::string chart;        ///< the file that the land is from; empty where there is none
};

/// S, P, N, N100, and archipelago:CELLS with any number of cells from 1,000 on:
///
///   S     maps/shangchuan.000, 112.45-113.10 E, 21.50-22.10 N, 143 x 159 cells of 470 m
///   P     the same window at 47 m, 2.3 million cells
///   N     the Norwegian coast of the test data, 4.5-7 E, 60-62 N at 93 m, 4 million cells
///   N100  the same at 18.6 m, 10^8 cells
///
/// Land alone blocks. Charts are in a transverse Mercator about the window's middle.
/// @throws std::runtime_error for another name, or if the chart is not there
World makeWorld(const std::string &name);

/// True if the world's chart can be found; those of N and N100 are looked for where SEAHEX_TEST_DATA says.
bool isAvailable(const std::string &name);

}  // namespace seahex::contest
