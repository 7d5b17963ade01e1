#include "Manifest.h"

#include <ompl/config.h>

#include <string>

namespace benchmark_planners
{
namespace
{

using Json = nlohmann::ordered_json;

Json position(const seahex::GeoPoint &place)
{
    return {toMillionths(place.latitudeDeg()), toMillionths(place.longitudeDeg())};
}

Json pairJson(const World &world, unsigned number)
{
    const PairFacts pair = world.pair(number);
    Json json = {{"number", number},
                 {"start", position(pair.start)},
                 {"goal", position(pair.goal)},
                 {"course_deg", toMillionths(pair.courseDeg)},
                 {"distance_m", toMillionths(pair.distanceM)}};
    if (pair.dive)
    {
        json["start"].push_back(toMillionths(pair.dive->startDepthM));
        json["goal"].push_back(toMillionths(pair.dive->goalDepthM));
        json["seabed_in_the_way"] = pair.dive->isSeabedInTheWay;
    }
    return json;
}

}  // namespace

Json makeManifest(const Options &options, const World &world)
{
    Json pairList = Json::array();
    for (unsigned number = 1; number <= world.pairCount(); ++number)
        pairList.push_back(pairJson(world, number));
    const std::string ompl = std::to_string(OMPL_MAJOR_VERSION) + "." + std::to_string(OMPL_MINOR_VERSION) + "." +
                             std::to_string(OMPL_PATCH_VERSION);
    return {{"program", "benchmark_planners"},
            {"format", 1},
            {"ompl", ompl},
            {"seed", options.seed},
            {"pairs", options.pairs},
            {"runs", options.runs},
            {"time_s", options.timeS},
            {"least_distance", options.leastDistance},
            {"planners", options.planners},
            {"arena", world.description()},
            {"pair_list", pairList}};
}

}  // namespace benchmark_planners
