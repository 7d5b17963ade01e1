#include "Manifest.h"

#include <ompl/config.h>

#include <cmath>
#include <cstdio>
#include <cstring>

namespace benchmark_planners
{
namespace
{

using Json = nlohmann::ordered_json;

/// FNV-1a over 64-bit words.
class Fingerprint
{
public:
    void add(std::uint64_t word)
    {
        for (int shift = 0; shift < 64; shift += 8)
            hash_ = (hash_ ^ ((word >> shift) & 0xff)) * 0x100000001b3ULL;
    }
    void add(double number)
    {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        add(bits);
    }
    std::string text() const
    {
        char text[24];
        std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash_));
        return text;
    }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

std::string fingerprintOf(const seahex::HexOccupancy &occupancy)
{
    Fingerprint fingerprint;
    fingerprint.add(occupancy.lattice().northWest().x());
    fingerprint.add(occupancy.lattice().northWest().y());
    fingerprint.add(occupancy.lattice().pitch());
    for (const std::uint64_t word : occupancy.words())
        fingerprint.add(word);
    return fingerprint.text();
}

/// To a millionth, as it is written.
double rounded(double value)
{
    return std::round(value * 1e6) / 1e6;
}

Json pairJson(const World &world, const demos::Pair &pair)
{
    const seahex::GeoPoint start = world.arena->projection().inverse(pair.start);
    const seahex::GeoPoint goal = world.arena->projection().inverse(pair.goal);
    return {{"number", pair.number},
            {"start", {rounded(start.latitudeDeg()), rounded(start.longitudeDeg())}},
            {"goal", {rounded(goal.latitudeDeg()), rounded(goal.longitudeDeg())}},
            {"course_deg", rounded(pair.courseDeg())},
            {"distance_m", rounded(pair.distance())}};
}

Json arenaJson(const World &world)
{
    Json charts = Json::array();
    for (const seahex::CellReport &cell : world.chart->cells)
        charts.push_back(cell.name);
    const seahex::HexOccupancy &occupancy = *world.arena->occupancy();
    const seahex::Vessel &vessel = world.arena->vessel();
    return {{"charts", charts},
            {"draught_m", vessel.draughtM},
            {"ukc_m", vessel.underKeelClearanceM},
            {"margin_m", vessel.marginM},
            {"pitch_m", rounded(occupancy.lattice().pitch())},
            {"columns", occupancy.lattice().columns()},
            {"rows", occupancy.lattice().rows()},
            {"blocked", occupancy.blockedCount()},
            {"fingerprint", fingerprintOf(occupancy)}};
}

}  // namespace

Json makeManifest(const Options &options, const World &world, const std::vector<demos::Pair> &pairs)
{
    Json pairList = Json::array();
    for (const demos::Pair &pair : pairs)
        pairList.push_back(pairJson(world, pair));
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
            {"arena", arenaJson(world)},
            {"pair_list", pairList}};
}

}  // namespace benchmark_planners
