#pragma once

#include <seahex/geometry/Point.h>

#include <functional>

namespace seahex
{

/// Is the straight segment between two points valid? Must be symmetric.
using SegmentPredicate = std::function<bool(const Point &, const Point &)>;

}  // namespace seahex
