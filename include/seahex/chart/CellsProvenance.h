#pragma once

#include <seahex/chart/Chart.h>
#include <seahex/chart/Projection.h>
#include <seahex/geometry/Lattice.h>
#include <seahex/world/BlockingRule.h>
#include <seahex/world/Vessel.h>

#include <string>

namespace seahex
{

/// What the cells of a chart are made of, in lines for people and to the last bit: cells of equal provenance are equal.
///
/// It names
/// - the program's version, and a digest of the sources that read, judge, project and fill, made when they are built;
/// - each file of the chart (base cells and updates): name without folder, size and digest of its bytes;
/// - what of it blocks for this vessel: a digest of every blocking geometry in degrees with its radius, and of the
///   coverage. Therefore also what no file tells counts: side files, settings of the drivers, cells left aside because
///   they lie away from the voyage, hazards put in by hand;
/// - vessel, scope, projection (with PROJ's release) and lattice.
///
/// Not in it: compiler and processor, which may round differently in the last place.
/// @throws ChartUnreadable if a file of the chart can't be read again
std::string cellsProvenance(const Chart &chart, const Vessel &vessel, HazardScope scope, const Projection &projection,
                            const Lattice &lattice);

}  // namespace seahex
