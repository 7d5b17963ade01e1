#include "Report.h"

#include "common/Failure.h"

#include <seahex/io/GeoJson.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <sstream>

namespace plan_dive
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

Json diveJson(const Result &result)
{
    Json waypoints = Json::array();
    for (std::size_t i = 0; i < result.written.waypoints.size(); ++i)
        waypoints.push_back({result.written.waypoints[i].latitudeDeg(), result.written.waypoints[i].longitudeDeg(),
                             result.written.depthsM[i]});
    const WrittenMeasures &m = result.measures;
    return {{"length_m", number(m.lengthM)},
            {"course_changes", result.track.courseChanges},
            {"course_angle_deg", number(result.track.courseAngleDeg)},
            {"least_water_m", number(m.leastWaterM)},
            {"least_depth_m", number(m.leastDepthM)},
            {"greatest_depth_m", number(m.greatestDepthM)},
            {"steepest", number(m.steepest)},
            {"waypoints", waypoints}};
}

Json slicesJson(const Result &result)
{
    if (!result.figures)
        return nullptr;
    return {{"length", number(result.figures->length)},
            {"danger", number(result.figures->danger)},
            {"total", number(result.figures->total)}};
}

Json seabedJson(const Result &result)
{
    const seahex::NodeGrid &grid = result.seabed.depths->grid();
    return {{"source", result.seabed.source},
            {"columns", grid.columns()},
            {"rows", grid.rows()},
            {"spacing_m", {number(grid.spacing().x()), number(grid.spacing().y())}},
            {"greatest_depth_m", number(static_cast<double>(result.seabed.depths->greatestDepth()))},
            {"frame", result.seabed.projection.name()},
            {"read_ms", number(result.seabed.readMs)},
            {"warnings", result.seabed.warnings()}};
}

std::string courseText(const demos::TrackMeasures &track)
{
    return format("%d course change%s of %.0f degrees in all", track.courseChanges, track.courseChanges == 1 ? "" : "s",
                  track.courseAngleDeg);
}

}  // namespace

std::string jsonReport(const Options &options, const Result &result)
{
    const seahex::DiveLimits &limits = result.arena->limits();
    const Json report = {{"status", "dive"},
                         {"exit", 0},
                         {"planner", options.planner},
                         {"dive", diveJson(result)},
                         {"slices", slicesJson(result)},
                         {"search_ms", number(result.searchMs)},
                         {"improvable", result.isImprovable},
                         {"limits",
                          {{"clearance_m", number(limits.clearanceM)},
                           {"ceiling_m", number(limits.ceilingM)},
                           {"deepest_m", number(limits.deepestM)},
                           {"climb", options.settings.climb > 0.0 ? Json(options.settings.climb) : Json(nullptr)},
                           {"margin_m", number(options.marginM)},
                           {"cross_cables_m", options.crossCablesM ? Json(*options.crossCablesM) : Json(nullptr)}}},
                         {"seabed", seabedJson(result)}};
    return report.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string summaryLine(const Options &options, const Result &result)
{
    return format("%s: %.2f km, %s, %.1f m of water below at least; %.0f ms", options.planner.c_str(),
                  result.measures.lengthM / 1000.0, courseText(result.track).c_str(), result.measures.leastWaterM,
                  result.searchMs);
}

std::string textReport(const Options &options, const Result &result)
{
    const seahex::NodeGrid &grid = result.seabed.depths->grid();
    const WrittenMeasures &m = result.measures;
    std::ostringstream out;
    out << "seabed    " << result.seabed.source
        << format(": %lld x %lld nodes, %.4g x %.4g m apart, %.0f m deep at most, read in %.0f ms\n",
                  static_cast<long long>(grid.columns()), static_cast<long long>(grid.rows()), grid.spacing().x(),
                  grid.spacing().y(), static_cast<double>(result.seabed.depths->greatestDepth()), result.seabed.readMs);
    for (const std::string &warning : result.seabed.warnings())
        out << "  warning: " << warning << "\n";
    out << format("search    %s, %.1f ms\n", options.planner.c_str(), result.searchMs);
    if (result.isImprovable)
        out << "          out of time after a first dive; with more --time it may become better\n";
    if (result.figures)
        out << format("          length %.2f vehicles, danger %.3f, F %.3f with K = %.2g\n", result.figures->length,
                      result.figures->danger, result.figures->total, options.settings.lengthWeight);
    out << format("dive      %.0f m, %s, %zu waypoints\n", m.lengthM, courseText(result.track).c_str(),
                  result.written.waypoints.size());
    out << format("          %.2f to %.2f m deep, %.2f m of water below at least, %s at the steepest\n", m.leastDepthM,
                  m.greatestDepthM, m.leastWaterM,
                  std::isfinite(m.steepest) ? format("%.4f m a metre", m.steepest).c_str() : "straight up or down");
    for (const std::string *file : {&options.out, &options.profile, &options.picture})
        if (!file->empty())
            out << "wrote     " << *file << "\n";
    return out.str();
}

void writeDiveFile(const Options &options, const Result &result)
{
    const WrittenMeasures &m = result.measures;
    seahex::RouteFileContent content;
    content.route = &result.written;
    content.numbers = {{"length_m", m.lengthM},
                       {"course_changes", static_cast<double>(result.track.courseChanges)},
                       {"course_angle_deg", result.track.courseAngleDeg},
                       {"least_water_m", m.leastWaterM},
                       {"clearance_m", options.limits.clearanceM},
                       {"ceiling_m", options.limits.ceilingM},
                       {"search_ms", result.searchMs}};
    content.texts = {{"planner", options.planner}, {"seabed", result.seabed.source}, {"warning", "not for navigation"}};
    try
    {
        seahex::writeGeoJson(options.out, content);
    }
    catch (const seahex::WriteError &error)
    {
        throw demos::Failure(demos::Exit::Usage, error.what());
    }
}

}  // namespace plan_dive
