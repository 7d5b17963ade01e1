#include "PlannerOptions.h"

#include "common/ChartOptions.h"
#include "common/Failure.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace plan_dive
{
namespace
{

constexpr const char *onSlices = "Slices (LayeredPlanner, LayeredPlanner-greedy, AntColony)";
constexpr const char *onPrisms = "PrismAStar";

[[noreturn]] void usage(const std::string &message)
{
    throw demos::Failure(demos::Exit::Usage, message);
}

void declareSlices(CLI::App &app, Options &o, PlannerTexts &t)
{
    const auto add = [&app](const char *name, auto &value, const char *help)
    {
        return app.add_option(name, value, help)->capture_default_str()->group(onSlices);
    };
    add("--K", o.settings.lengthWeight, "weight of length against danger, 0 to 1")->type_name("K");
    add("--vehicle-length", t.vehicleLength, "by which lengths are divided, metres; auto: the distance between slices")
        ->type_name("M|auto");
    add("--slices", o.settings.slices, "slices across the course")->type_name("N");
    add("--across", o.settings.across, "points across each slice")->type_name("N");
    add("--levels", o.settings.levels, "levels of depth")->type_name("N");
}

void declarePrisms(CLI::App &app, Options &o, PlannerTexts &t)
{
    const auto add = [&app](const char *name, auto &value, const char *help)
    {
        return app.add_option(name, value, help)->capture_default_str()->group(onPrisms);
    };
    add("--climb", o.settings.climb,
        "steepest that the vehicle climbs or dives, metres in a metre over ground; 0: not limited")
        ->type_name("SLOPE");
    add("--rings", o.settings.rings, "rings of jumps between hexagons, 1, 2 or 3")->type_name("N");
    add("--cell-size", t.cellSize,
        "pitch of the hexagons, metres; auto: a 200th of the larger side of the waters searched")
        ->type_name("M|auto");
    add("--layer", t.layer,
        "from a layer of depth to the next, metres at most; auto: what the climb reaches in a cell, but four steps at "
        "least, and 16 steps without --climb")
        ->type_name("M|auto");
}

void refuseUnknownTo(const CLI::App &app, const Options &o)
{
    for (const CLI::Option *option : app.get_options())
    {
        const bool isOthers = (option->get_group() == onSlices && !demos::plansOnSlices(o.planner)) ||
                              (option->get_group() == onPrisms && !demos::plansOnPrisms(o.planner));
        if (isOthers && option->count() > 0)
            usage(option->get_name() + " has no meaning with --planner " + o.planner +
                  "; planners that know it: " + option->get_group());
    }
}

void checkCount(const char *option, unsigned count)
{
    if (count < 2 || count > 1000)
        usage(std::string(option) + " must be 2 to 1000, not " + std::to_string(count));
}

}  // namespace

double positiveOrAuto(const char *option, const std::string &text)
{
    if (text == "auto")
        return 0.0;
    double value = 0.0;
    if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value) || value <= 0.0)
        usage(std::string(option) + " must be a positive number of metres or auto, not '" + text + "'");
    return value;
}

void declarePlanner(CLI::App &app, Options &o, PlannerTexts &t)
{
    app.add_option("--planner", o.planner, "one of " + demos::divePlannerNames())
        ->capture_default_str()
        ->type_name("NAME");
    app.add_option("--time", o.timeS, "time limit of the search, seconds; sampling planners use all of it")
        ->capture_default_str()
        ->type_name("S");
    app.add_option("--seed", o.settings.seed, "seed of ants and sampling planners")
        ->capture_default_str()
        ->type_name("N");
    declareSlices(app, o, t);
    declarePrisms(app, o, t);
}

void resolvePlanner(const CLI::App &app, Options &o, const PlannerTexts &t)
{
    if (!demos::isDivePlannerName(o.planner))
        usage("--planner: there is no planner of dives '" + o.planner + "'; known are " + demos::divePlannerNames());
    refuseUnknownTo(app, o);
    demos::requireNotNegative("--time", o.timeS, "seconds");
    o.settings.vehicleLengthM = positiveOrAuto("--vehicle-length", t.vehicleLength);
    if (!(o.settings.lengthWeight >= 0.0 && o.settings.lengthWeight <= 1.0))
        usage("--K must be 0 to 1, not " + demos::plain(o.settings.lengthWeight));
    checkCount("--slices", o.settings.slices);
    checkCount("--across", o.settings.across);
    checkCount("--levels", o.settings.levels);
    const double points = double(o.settings.slices) * o.settings.across * o.settings.levels;
    if (points > 1e6)
        usage("--slices, --across and --levels make " + demos::plain(points) +
              " points, and at most 1e+06 are possible");
    demos::requireNotNegative("--climb", o.settings.climb, "metres in a metre over ground");
    if (o.settings.rings < 1 || o.settings.rings > 3)
        usage("--rings must be 1, 2 or 3, not " + std::to_string(o.settings.rings));
    o.settings.cellSizeM = positiveOrAuto("--cell-size", t.cellSize);
    o.settings.layerM = positiveOrAuto("--layer", t.layer);
}

}  // namespace plan_dive
