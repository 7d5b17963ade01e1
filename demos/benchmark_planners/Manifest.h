#pragma once

#include "Options.h"
#include "World.h"

#include <nlohmann/json.hpp>

namespace benchmark_planners
{

/// All that decides the results of a campaign: settings, the world with a fingerprint of its numbers, and the pairs.
/// What only decides how it is run (jobs at a time, shard, folder) is left out, and so is where anything lies on this
/// machine.
nlohmann::ordered_json makeManifest(const Options &options, const World &world);

}  // namespace benchmark_planners
