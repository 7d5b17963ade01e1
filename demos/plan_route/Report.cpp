#include "Report.h"

#include "common/Failure.h"

#include <seahex/io/GeoJson.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <sstream>

namespace plan_route
{
namespace
{

using Json = nlohmann::ordered_json;

std::string format(const char *pattern, ...) __attribute__((format(printf, 1, 2)));

std::string format(const char *pattern, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text, sizeof text, pattern, arguments);
    va_end(arguments);
    return text;
}

/// null for what is not finite: JSON has no infinity
Json number(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json cellJson(seahex::HexCoord cell)
{
    return Json::array({cell.q, cell.r(), cell.s});
}

Json routeJson(const MeasuredRoute &route)
{
    Json waypoints = Json::array();
    for (const seahex::GeoPoint &p : route.written.waypoints)
        waypoints.push_back({p.latitudeDeg(), p.longitudeDeg()});
    Json crosses = Json::array();
    for (const seahex::HazardObject *object : route.crosses)
        crosses.push_back({{"class", object->objectClass},
                           {"feature", object->featureId},
                           {"cell", object->cell},
                           {"description", describe(*object)}});
    const seahex::RouteMetrics &m = route.metrics;
    return {{"length_m", number(m.lengthM)},
            {"length_nm", number(m.lengthNm())},
            {"length_cells", number(m.lengthCells)},
            {"length_lattice", number(m.lengthLattice)},
            {"turns", m.turns},
            {"turn_angle_deg", number(m.turnAngleDeg())},
            {"min_clearance_m", number(m.minClearanceM)},
            {"potential_hazards", m.potentialHazards},
            {"crosses", crosses},
            {"waypoints", waypoints}};
}

template <class Value>
Json optionalJson(const std::optional<Value> &value)
{
    return value ? Json(*value) : Json(nullptr);
}

Json cellReportJson(const seahex::CellReport &cell)
{
    const seahex::GroupOneCheck &check = cell.groupOne;
    return {{"name", cell.name},
            {"source", cell.source},
            {"edition", optionalJson(cell.edition)},
            {"update", optionalJson(cell.update)},
            {"issued", cell.issueDate},
            {"scale", optionalJson(cell.scale)},
            {"vertical_datum", optionalJson(cell.verticalDatum)},
            {"sounding_datum", optionalJson(cell.soundingDatum)},
            {"bounds", {cell.bounds.westDeg, cell.bounds.southDeg, cell.bounds.eastDeg, cell.bounds.northDeg}},
            {"group_one",
             {{"applicable", check.applicable},
              {"tiles", check.tiles},
              {"twice_area_difference", check.twiceAreaDifference},
              {"gap_fraction", number(check.gapFraction)}}},
            {"features_read", cell.featuresRead},
            {"features_used", cell.featuresUsed},
            {"skipped", cell.skipped},
            {"warnings", cell.warnings}};
}

Json chartJson(const seahex::Chart &chart)
{
    std::size_t read = 0;
    std::size_t used = 0;
    Json cells = Json::array();
    for (const seahex::CellReport &cell : chart.cells)
    {
        read += cell.featuresRead;
        used += cell.featuresUsed;
        cells.push_back(cellReportJson(cell));
    }
    return {{"cells", cells},
            {"features_read", read},
            {"features_used", used},
            {"features_skipped", read - used},
            {"read_ms", number(chart.readMs)}};
}

void describeRoute(std::ostream &out, const char *name, const MeasuredRoute &route)
{
    const seahex::RouteMetrics &m = route.metrics;
    out << format("%-9s %.0f m (%.2f NM), %.2f cell widths, %d turns of %.0f degrees in all, %zu waypoints\n", name,
                  m.lengthM, m.lengthNm(), m.lengthCells, m.turns, m.turnAngleDeg(), route.written.waypoints.size());
    if (std::isfinite(m.minClearanceM))
        out << format("          %.0f m from the nearest hazard; ", m.minClearanceM);
    else
        out << "          no hazard on the chart; ";
    out << format("%lld blocked cells beside it\n", static_cast<long long>(m.potentialHazards));
}

void describeChart(std::ostream &out, const seahex::Chart &chart)
{
    for (const seahex::CellReport &cell : chart.cells)
    {
        out << "chart     " << cell.name;
        if (cell.scale)
            out << " 1:" << *cell.scale;
        if (cell.edition)
            out << ", edition " << *cell.edition << " update " << cell.update.value_or(0);
        out << ", " << cell.featuresUsed << " of " << cell.featuresRead << " features used\n";
        for (const std::string &warning : cell.warnings)
            out << "  warning: " << warning << "\n";
    }
}

}  // namespace

std::string jsonReport(const Options &options, const Result &result)
{
    const seahex::HexOccupancy &occupancy = *result.arena->occupancy();
    const Json report = {{"status", "route"},
                         {"exit", 0},
                         {"planner", options.planner},
                         {"raw", routeJson(result.raw)},
                         {"smoothed", result.smoothed ? routeJson(*result.smoothed) : Json(nullptr)},
                         {"expanded", result.expanded},
                         {"search_ms", number(result.searchMs)},
                         {"proven_shortest", result.isProvenShortest},
                         {"improvable", result.isImprovable},
                         {"chart", chartJson(*result.chart)},
                         {"cells_from", result.arena->isFromFile() ? "file" : "chart"},
                         {"cells_warnings", result.arena->warnings()},
                         {"lattice",
                          {{"pitch", number(occupancy.lattice().pitch())},
                           {"unit", result.arena->projection().isMetric() ? "m" : "degree"},
                           {"columns", occupancy.lattice().columns()},
                           {"rows", occupancy.lattice().rows()},
                           {"blocked", occupancy.blockedCount()},
                           {"build_ms", number(result.arena->buildMs())},
                           {"frame", result.arena->projection().name()}}},
                         {"start_cell", cellJson(result.startCell)},
                         {"goal_cell", cellJson(result.goalCell)}};
    return report.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string summaryLine(const Options &options, const Result &result)
{
    const seahex::RouteMetrics &m = result.best().metrics;
    return format("%s: %.2f NM, %d turns, %.0f degrees; %llu cells expanded in %.1f ms", options.planner.c_str(),
                  m.lengthNm(), m.turns, m.turnAngleDeg(), static_cast<unsigned long long>(result.expanded),
                  result.searchMs);
}

std::string textReport(const Options &options, const Result &result)
{
    const seahex::HexOccupancy &occupancy = *result.arena->occupancy();
    const seahex::HexLattice &lattice = occupancy.lattice();
    std::ostringstream out;
    describeChart(out, *result.chart);
    out << format("cells     %lld x %lld, pitch %.4g %s, %lld blocked, %s in %.0f ms\n",
                  static_cast<long long>(lattice.columns()), static_cast<long long>(lattice.rows()), lattice.pitch(),
                  result.arena->projection().isMetric() ? "m" : "degrees",
                  static_cast<long long>(occupancy.blockedCount()),
                  result.arena->isFromFile() ? "taken from the file" : "filled", result.arena->buildMs());
    for (const std::string &warning : result.arena->warnings())
        out << "  warning: " << warning << "\n";
    out << format("search    %s, %llu cells expanded, %.1f ms\n", options.planner.c_str(),
                  static_cast<unsigned long long>(result.expanded), result.searchMs);
    if (result.isImprovable)
        out << "          out of time after a first route; with more --time it may become better\n";
    describeRoute(out, "path", result.raw);
    if (options.metric == seahex::LengthMetric::Lattice)
        out << format("          %.0f steps between cells\n", result.raw.metrics.lengthLattice);
    if (result.smoothed)
        describeRoute(out, "route", *result.smoothed);
    if (result.isProvenShortest)
        out << "          proven: no route around these cells is shorter, but for some millionths\n";
    if (result.best().crosses.empty())
        out << "crosses   no bridge, overhead cable, regulated area or other object of caution\n";
    for (const seahex::HazardObject *object : result.best().crosses)
        out << "crosses   " << describe(*object) << ": look at it yourself\n";
    if (!options.out.empty())
        out << "wrote     " << options.out << "\n";
    if (!options.picture.empty())
        out << "wrote     " << options.picture << "\n";
    return out.str();
}

void writeRouteFile(const Options &options, const Result &result)
{
    const seahex::RouteMetrics &m = result.best().metrics;
    seahex::RouteFileContent content;
    content.route = &result.best().written;
    content.rawPath = &result.raw.written;
    content.blocked = options.blockedCells ? result.arena->occupancy().get() : nullptr;
    content.projection = &result.arena->projection();
    content.numbers = {{"length_m", m.lengthM},
                       {"length_nm", m.lengthNm()},
                       {"length_cells", m.lengthCells},
                       {"length_lattice", m.lengthLattice},
                       {"turns", m.turns},
                       {"turn_angle_deg", m.turnAngleDeg()},
                       {"potential_hazards", static_cast<double>(m.potentialHazards)},
                       {"expanded", static_cast<double>(result.expanded)},
                       {"search_ms", result.searchMs}};
    if (std::isfinite(m.minClearanceM))
        content.numbers["min_clearance_m"] = m.minClearanceM;
    content.texts = {{"planner", options.planner}, {"warning", "not for navigation"}};
    try
    {
        seahex::writeGeoJson(options.out, content);
    }
    catch (const seahex::WriteError &error)
    {
        throw demos::Failure(demos::Exit::Usage, error.what());
    }
}

}  // namespace plan_route
