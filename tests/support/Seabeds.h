#pragma once

#include <seahex/world/DiveArena.h>

#include "support/Random.h"

#include <memory>

namespace seahex::test
{

/// A random seabed of ridges and holes, from about -10 to 60 m, some nodes unknown.
std::shared_ptr<const Bathymetry> randomSeabed(Random &random, std::int64_t columns, std::int64_t rows,
                                               double unknownShare);

/// A position in the box of an arena, its ends included now and then.
Point3 anyPosition(Random &random, const DiveArena &arena);

/// A free position, found by trying. @throws std::runtime_error if a thousand are not
Point3 freePosition(Random &random, const DiveArena &arena);

}  // namespace seahex::test
