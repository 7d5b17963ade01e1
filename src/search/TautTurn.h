#pragma once

#include "search/HexStrips.h"

namespace seahex
{

/// How a taut path turns at a corner of the blocked cells.
///
/// Three cells meet in a corner; a path can turn there only if just one of them is blocked, and it turns around that
/// one: it goes on between straight ahead and the blocked cell's edge that leaves the corner, at most 60 degrees.
///
/// One line of the strips runs through the corner. On one side of the line lie the middle parts of a row, two of whose
/// cells meet in the corner (the side `way`, row `row`); on the other side lies the tip of the third cell.
struct TautTurn
{
    enum class Along
    {
        Nothing,  ///< no taut turn
        Tip,      ///< the tip is blocked; along its slanted edge, side and away from the row
        Slanted,  ///< a cell of the row, on `side`, is blocked; along its slanted edge, away from the row
        Upright   ///< a cell of the row, not on `side`, is blocked; along its upright edge
    };

    Along along = Along::Nothing;
    int way = 0;   ///< 1 if the row lies south of the corner, -1 north
    int side = 0;  ///< 1 if the path goes on east, -1 west
    HexStrips::Whole row = 0;
    HexStrips::Whole x = 0;  ///< of the corner

    /// The turn at a corner reached from a direction.
    /// @param dx, dy  from anywhere to the corner
    TautTurn(const HexStrips &strips, StripPoint corner, double dx, double dy);

    /// True if the turn leads into a pocket: out of the free cell ahead there is no way but through blocked ones.
    /// @param goalRow, goalX  the cell in which the path may end
    bool isPocket(const HexStrips &strips, double dx, double dy, HexStrips::Whole goalRow,
                  HexStrips::Whole goalX) const;
};

}  // namespace seahex
