#pragma once

#include "Table.h"

#include <seahex/chart/ChartArena.h>
#include <seahex/io/Picture.h>
#include <seahex/io/SeabedPicture.h>

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

/// Likewise, in three dimensions.
struct SeabedFigure
{
    std::string name;
    seahex::SeabedPictureContent content;
};

/// What reproducing one paper's experiment gives.
struct Study
{
    std::vector<Table> tables;
    std::vector<Figure> figures;
    std::vector<SeabedFigure> seabeds;
};

}  // namespace reproduce_papers
