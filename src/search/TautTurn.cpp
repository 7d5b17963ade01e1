#include "search/TautTurn.h"

namespace seahex
{
namespace
{

/// Components of vectors between corners are whole numbers; those from a start differ from a corner's by rounding.
constexpr double level = 1e-9;

}  // namespace

TautTurn::TautTurn(const HexStrips &strips, StripPoint corner, double dx, double dy)
{
    x = static_cast<HexStrips::Whole>(corner.x);
    const auto y = static_cast<HexStrips::Whole>(corner.y);
    const HexStrips::Whole third = y / 3;
    way = y % 3 == 0 ? -1 : 1;
    row = way > 0 ? third : third - 1;
    const bool tip = strips.isBlocked(row - way, x);
    const bool west = strips.isBlocked(row, x - 1);
    const bool east = strips.isBlocked(row, x + 1);
    if (tip + west + east != 1)
        return;
    // Edges lie at slopes of one half pitch to one half side, or upright.
    const double across = std::abs(dx);
    const double ahead = dy * way;  // towards the row
    if (tip)
    {
        if (across < std::abs(ahead) - level || ahead <= level - across)
            return;
        along = Along::Tip;
        side = dx > 0.0 ? 1 : -1;
        return;
    }
    if (across > std::abs(ahead) + level)
        return;
    const int blockedSide = east ? 1 : -1;
    if (ahead < 0.0)
    {
        if (dx * blockedSide < -level || across >= std::abs(ahead) - level)
            return;
        along = Along::Slanted;
        side = blockedSide;
    }
    else
    {
        if (dx * blockedSide >= -level)
            return;
        along = Along::Upright;
        side = -blockedSide;
    }
}

bool TautTurn::isPocket(const HexStrips &strips, double dx, double dy, HexStrips::Whole goalRow,
                        HexStrips::Whole goalX) const
{
    // The free cell ahead lies beyond the edge along which the path turns. That edge ends in a corner of `next`, and
    // the cell's next edge but one is that of `beyond`. A path that goes on within 30 degrees of the edge leaves the
    // cell through the edge of `next`, any other through one of the two.
    const double across = std::abs(dx);
    const double ahead = dy * way;  // towards the row
    switch (along)
    {
        case Along::Tip:
            if (goalRow == row && goalX == x + side)
                return false;
            return strips.isBlocked(row - way, x + 2 * side) && (ahead < -level || strips.isBlocked(row, x + 3 * side));
        case Along::Slanted:
            if (goalRow == row - way && goalX == x)
                return false;
            return strips.isBlocked(row - way, x + 2 * side) &&
                   (3.0 * across > -ahead + level || strips.isBlocked(row - 2 * way, x + side));
        case Along::Upright:
            if (goalRow == row && goalX == x + side)
                return false;
            return strips.isBlocked(row + way, x) &&
                   (3.0 * across < ahead - level || strips.isBlocked(row + way, x + 2 * side));
        case Along::Nothing:
            break;
    }
    return true;
}

}  // namespace seahex
