#pragma once

#include "Table.h"

#include <seahex/chart/ChartArena.h>
#include <seahex/io/Picture.h>

#include <memory>
#include <string>
#include <vector>

namespace reproduce_papers
{

/// A picture to be written: file name without extension, and what it shows.
struct Figure
{
    std::string name;
    seahex::PictureContent content;
    std::shared_ptr<const seahex::ChartArena> arena;  ///< owns the shapes that the content points to
};

/// What reproducing one paper's experiment gives.
struct Study
{
    std::vector<Table> tables;
    std::vector<Figure> figures;
};

}  // namespace reproduce_papers
