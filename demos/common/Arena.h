#pragma once

#include <seahex/chart/Chart.h>
#include <seahex/chart/ChartArena.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace demos
{

/// seahex::readChart.
/// @throws Failure (Exit::Chart)
std::shared_ptr<const seahex::Chart> readChart(const std::vector<std::string> &sources,
                                               const std::optional<seahex::GeoBox> &window = std::nullopt);

/// The warnings of all cells of a chart.
std::vector<std::string> warningsOf(const seahex::Chart &chart);

/// A chart's arena that has water.
/// @throws Failure (Exit::Usage) if the pitch is too small or not possible, (Exit::Chart) if no cell is navigable or
///         its files can't be read again
std::shared_ptr<const seahex::ChartArena> makeArena(const seahex::Chart &chart, const seahex::ArenaOptions &options);

/// Refuses a pitch that would fill the memory: a search takes up to 10 bytes a cell.
/// @throws Failure (Exit::Usage)
void checkCellCount(double pitch, double cells);

}  // namespace demos
