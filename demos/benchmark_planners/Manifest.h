#pragma once

#include "Options.h"
#include "World.h"
#include "common/Pairs.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace benchmark_planners
{

/// All that decides the results of a campaign: settings, the arena with a fingerprint of its cells, and the pairs. What
/// only decides how it is run (jobs at a time, shard, folder) is left out, and so is where anything lies on this
/// machine.
nlohmann::ordered_json makeManifest(const Options &options, const World &world, const std::vector<demos::Pair> &pairs);

}  // namespace benchmark_planners
