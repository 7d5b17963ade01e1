#pragma once

#include "Study.h"

namespace reproduce_papers
{

/// The experiment of [Wang2017] section 4 on this project's own charts: table 1 for a pair across the islands of its
/// window, and for the waters of [Cheng2020]; on squares as published, and on hexagons.
/// @throws demos::Failure as reading a chart does
Study wangStudy();

}  // namespace reproduce_papers
