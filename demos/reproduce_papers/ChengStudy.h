#pragma once

#include "Study.h"

namespace reproduce_papers
{

/// The experiment of [Cheng2020] section 3 on this project's own chart of the same waters: tables 2 and 3, the figures
/// 3 to 6, and what the guides expand.
/// @throws demos::Failure as reading a chart does
Study chengStudy();

}  // namespace reproduce_papers
