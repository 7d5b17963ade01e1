#pragma once

#include <seahex/chart/Chart.h>
#include <seahex/chart/Projection.h>
#include <seahex/world/Bathymetry.h>

#include <memory>

namespace seahex
{

/// What to make of the water between a chart's soundings.
enum class ChartDepths
{
    Least,        ///< what the chart promises: each depth area's least depth (DRVAL1)
    Interpolated  ///< an estimate: the TIN of soundings and depth contours, kept between the area's DRVAL1 and DRVAL2
};

/// The seabed of an S-57 chart as a grid of nodes over its coverage, metres below the chart's sounding datum.
///
/// Guaranteed, at every point and not at the nodes only (each node takes the least of the four cells around it, and
/// cells are filled by any touch): a depth is never greater than
/// - Least: DRVAL1 of any depth area (DEPARE, DRGARE) that touches the grid's cell; an area without DRVAL1 counts -1 m;
/// - Interpolated: DRVAL2 of any such area, or DRVAL1 where it has none;
/// - both: any sounding in the cell, VALDCO of any depth contour (DEPCNT) that touches it, and VALSOU of any danger
///   (rocks, wrecks, obstructions, marine farms) that does.
/// In a sound chart the areas say what the contours do: they meet along contours, the shoaler one ends at VALDCO
/// (DRVAL2), the deeper one begins there (DRVAL1), and both touch the contour's cells. Between contours Least promises
/// the shoaler one's depth.
///
/// Unknown is every cell that land, unsurveyed water, a gap of the chart, a pontoon, hulk or dock, a danger or sounding
/// without depth, or what lies outside the coverage touches. The chart's edges count as they lie in the frame, grown by
/// its edgeToleranceM.
///
/// The TIN (Delaunay, linear in each triangle) has all soundings and, in each cell that contours pass, one point of the
/// shallowest. Where all three corners of a triangle lie on one contour it is flat there, at that depth.
///
/// Not guaranteed: that nothing shoaler lies between soundings than Interpolated says (Least says what the chart does);
/// piles, buoys, cables and other things that stand in the water are no seabed: they are columns to keep out of
/// (HazardScope::WaterColumn).
///
/// @param projection  a frame in metres
/// @param spacingM    from node to node, > 0
/// @throws std::domain_error for a frame of degrees, a spacing that is not positive, or more than 10^8 cells
/// @throws ChartEmpty if no cell of that size lies wholly in water of known depth
std::shared_ptr<const Bathymetry> chartBathymetry(const Chart &chart, const Projection &projection, double spacingM,
                                                  ChartDepths depths = ChartDepths::Least);

}  // namespace seahex
