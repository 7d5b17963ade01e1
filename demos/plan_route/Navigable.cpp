#include "Navigable.h"

#include "common/Failure.h"

#include <seahex/io/GeoRoute.h>
#include <seahex/world/Clearance.h>
#include <seahex/world/SegmentValidity.h>

#include <cmath>
#include <cstdio>

namespace plan_route
{
namespace
{

using seahex::GeoPoint;
using seahex::Point;

std::string joined(const std::vector<std::string> &reasons)
{
    constexpr std::size_t most = 3;
    std::string text;
    for (std::size_t i = 0; i < reasons.size() && i < most; ++i)
        text += (i == 0 ? "" : "; ") + reasons[i];
    if (reasons.size() > most)
        text += "; and " + std::to_string(reasons.size() - most) + " more";
    return text;
}

std::string nearestNavigable(const seahex::ChartArena &arena, const GeoPoint &position, const Point &p)
{
    const auto free = seahex::nearestFree(*arena.occupancy(), p);
    if (!free)
        return "no position on this chart is navigable";
    const GeoPoint nearest =
        arena.projection().inverse(arena.occupancy()->lattice().centre(seahex::toCube(free->cell)));
    const double distance = seahex::rhumbLengthM({{position, nearest}});
    char text[160];
    std::snprintf(text, sizeof text, "nearest navigable position %.6f,%.6f, %.0f m away", nearest.latitudeDeg(),
                  nearest.longitudeDeg(), distance);
    return text;
}

std::string swappedHint(const seahex::Chart &chart, const GeoPoint &position)
{
    if (std::abs(position.longitudeDeg()) > 90.0)
        return "";
    const GeoPoint swapped = GeoPoint::fromLatLon(position.longitudeDeg(), position.latitudeDeg());
    return chart.bounds.contains(swapped) ? "; with latitude and longitude swapped it would lie on the chart" : "";
}

}  // namespace

seahex::HexCoord navigableCell(const seahex::Chart &chart, const seahex::ChartArena &arena, const GeoPoint &position,
                               const std::string &role)
{
    const std::string who = role + " " + toString(position);
    if (!chart.bounds.contains(position))
        throw demos::Failure(demos::Exit::NotNavigable,
                             who + " lies outside the chart, which covers " +
                                 toString(GeoPoint::fromLatLon(chart.bounds.southDeg, chart.bounds.westDeg)) + " to " +
                                 toString(GeoPoint::fromLatLon(chart.bounds.northDeg, chart.bounds.eastDeg)) +
                                 swappedHint(chart, position));
    const Point p = arena.projection().forward(position);
    const seahex::HexCoord cell = arena.occupancy()->lattice().cellAt(p);
    if (isFree(*arena.occupancy(), p, p))
        return cell;

    const std::vector<std::string> atPoint = arena.explainPoint(p);
    if (!atPoint.empty())
        throw demos::Failure(demos::Exit::NotNavigable, who + " is not navigable: " + joined(atPoint) + "; " +
                                                            nearestNavigable(arena, position, p));
    const std::vector<std::string> atCell = arena.explainCell(cell);
    throw demos::Failure(
        demos::Exit::NotNavigable,
        "the cell around " + who + " is not navigable: " +
            (atCell.empty() ? std::string("the position touches the edge of the lattice or of a blocked cell")
                            : joined(atCell)) +
            "; the position itself is clear, so a finer --pitch may help; " + nearestNavigable(arena, position, p));
}

}  // namespace plan_route
