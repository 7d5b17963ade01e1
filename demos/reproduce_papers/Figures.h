#pragma once

#include "Sea.h"
#include "Study.h"

#include <seahex/chart/ChartArena.h>

#include <optional>

namespace reproduce_papers
{

/// A picture as the papers have them: land, blocked cells, expanded cells, the path from centre to centre and, where
/// there is one, what became of it.
/// @param title  its first line is set larger
Figure makeFigure(const std::string &name, const std::string &title, const Sea &sea, Cells cells,
                  const std::shared_ptr<const seahex::ChartArena> &arena, const Answer &answer,
                  const std::optional<seahex::Route> &smoothed = std::nullopt);

}  // namespace reproduce_papers
