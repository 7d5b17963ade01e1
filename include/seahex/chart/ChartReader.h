#pragma once

#include <seahex/chart/Chart.h>

#include <optional>
#include <string>
#include <vector>

namespace seahex
{

/// Reads charts.
///
/// A source is an S-57 cell (`NAME.000`; its updates `.001` and on are applied), a folder in which cells are looked for
/// (two levels deep, `ENC_ROOT/NAME/NAME.000` included), or any OGR source (GeoPackage, GeoJSON, shapefile, a folder of
/// these) whose layers bear the acronyms of S-57 classes, in any case. OGR sources given together are read as one cell;
/// in other coordinate systems than WGS-84 degrees they are transformed.
///
/// What is checked, because a chart that is read wrongly is worse than none: the number of feature and spatial records
/// against the header of the cell and of every update, the group 1 tiling against the coverage (a gap becomes a hazard
/// of rule ChartGap and a warning), the units of depths and positions, the sequence and edition of updates, that every
/// object of a blocking class has a geometry, and that every coordinate is a position. What was not used, and why, is
/// in the report of each cell, as are the words of the drivers.
///
/// If a window is given, cells whose coverage lies outside of it are left aside and named in a warning (unless none
/// would be left): from a folder of many cells only those near the voyage are then planned on.
///
/// Limits: a chart may span 60 degrees of longitude within -180 to 180, none across the antimeridian. Areas of an OGR
/// source that meet should share their corners: where only one of them has a corner on a common edge that is bent by a
/// transformation, a gap opens, which blocks. Updates of a cell that is re-issued are refused, because GDAL does not
/// apply them.
///
/// Thread-safe: calls share nothing.
///
/// @throws ChartUnreadable, ChartDamaged, ChartUnsupported, ChartEmpty
Chart readChart(const std::vector<std::string> &sources, const std::optional<GeoBox> &window = std::nullopt);
Chart readChart(const std::string &source);

}  // namespace seahex
