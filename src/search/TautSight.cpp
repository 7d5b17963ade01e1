#include "search/TautExpansion.h"

#include <algorithm>
#include <cmath>
#include <limits>

// What a root sees of a row, of the tips beyond, and of the goal there.

namespace seahex
{
namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

void TautSearch::Expansion::crossRow(const View &view, Whole row, int way)
{
    const double exit = HexStrips::exitLine(row, way);
    const double depth = std::abs(exit - view.from.y);
    View next = view;
    next.west = view.from.x + view.westSlope * depth;
    next.east = view.from.x + view.eastSlope * depth;

    // a blocked cell's upright wall, where it stands between the ray and what is seen
    const Whole inWest = strips_.blockedWest(row, HexStrips::cellWestOf(row, view.west), next.west - nearness - 1.0);
    const Whole inEast = strips_.blockedEast(row, HexStrips::cellEastOf(row, view.east), next.east + nearness + 1.0);
    const double westWall = inWest == HexStrips::none ? -infinite : static_cast<double>(inWest + 1);
    const double eastWall = inEast == HexStrips::none ? infinite : static_cast<double>(inEast - 1);
    if (!goalAmongTips_ && goalNorthRow_ == row && seesGoalInRow(view, westWall, eastWall, way))
        pushGoal(view.root);
    const bool atWestWall = next.west <= westWall + nearness;
    const bool atEastWall = next.east >= eastWall - nearness;
    if (atWestWall)
    {
        next.west = westWall;
        next.westSlope = (westWall - view.from.x) / depth;
    }
    if (atEastWall)
    {
        next.east = eastWall;
        next.eastSlope = (eastWall - view.from.x) / depth;
    }
    if (next.west > next.east + nearness)
        return;
    if (atWestWall)
        next.westCorner = see(view.root, westWall, exit);
    if (atEastWall)
        next.eastCorner = see(view.root, eastWall, exit);
    crossTips(next, row, way);
}

void TautSearch::Expansion::crossTips(View view, Whole row, int way)
{
    const Whole next = row + way;
    const double exit = HexStrips::exitLine(row, way);
    const double depth = std::abs(exit - view.from.y);
    const double farDepth = depth + 1.0;
    if (isGoalAmongTips(row, way))
        lookForGoalAmongTips(view, row, way);

    // Tips of blocked cells of the next row stand on the exit line and part what is seen there. Only those that a
    // shallow ray passes can turn a taut path, and of a run of blocked cells only the last; a steep ray that passes one
    // is cut off by the cell's shoulder on the next line.
    const Whole firstTip = HexStrips::firstCentreFrom(next, view.west - nearness);
    const Whole lastTip = HexStrips::lastCentreTo(next, view.east + nearness);
    const auto slopeOf = [&](double tip)
    {
        return (tip - view.from.x) / depth;
    };
    const std::uint32_t lastCorner = view.eastCorner;

    Part part = {view.from.x + view.westSlope * farDepth, 0.0, false, false};
    const double westEnd = westEndAmongTips(row, next, view.west, firstTip - 2, part.west);
    if (part.west <= westEnd + nearness)
    {
        part.west = westEnd;
        part.endsWest = true;
    }
    Whole blocked = strips_.blockedEast(next, firstTip, static_cast<double>(lastTip));
    while (blocked != HexStrips::none)
    {
        const double tip = static_cast<double>(blocked);
        const double slope = slopeOf(tip);
        view.eastCorner = slope <= nearness - 1.0 ? see(view.root, tip, exit) : 0;
        part.endsEast = slope >= -1.0 - nearness;
        part.east = part.endsEast ? tip - 1.0 : tip + slope;
        pushPart(view, next, way, part);

        const Whole free = strips_.freeEast(next, blocked, static_cast<double>(lastTip + 2));
        if (free == HexStrips::none)
            return;  // what is left is a pocket
        const double last = static_cast<double>(free - 2);
        const double lastSlope = slopeOf(last);
        view.westCorner = lastSlope >= 1.0 - nearness ? see(view.root, last, exit) : 0;
        part.endsWest = lastSlope <= 1.0 + nearness;
        part.west = part.endsWest ? last + 1.0 : last + lastSlope;
        blocked = strips_.blockedEast(next, free, static_cast<double>(lastTip));
    }
    view.eastCorner = lastCorner;
    part.east = view.from.x + view.eastSlope * farDepth;
    const double eastEnd = eastEndAmongTips(row, next, view.east, lastTip + 2, part.east);
    part.endsEast = part.east >= eastEnd - nearness;
    if (part.endsEast)
        part.east = eastEnd;
    pushPart(view, next, way, part);
}

double TautSearch::Expansion::westEndAmongTips(Whole row, Whole next, double place, Whole tip, double ray) const
{
    const Whole shoulder = strips_.blockedWest(next, tip, ray - nearness - 1.0);
    const Whole apex = strips_.blockedWest(row, HexStrips::cellWestOf(row, place), ray - nearness);
    return std::max(shoulder == HexStrips::none ? -infinite : static_cast<double>(shoulder + 1),
                    apex == HexStrips::none ? -infinite : static_cast<double>(apex));
}

double TautSearch::Expansion::eastEndAmongTips(Whole row, Whole next, double place, Whole tip, double ray) const
{
    const Whole shoulder = strips_.blockedEast(next, tip, ray + nearness + 1.0);
    const Whole apex = strips_.blockedEast(row, HexStrips::cellEastOf(row, place), ray + nearness);
    return std::min(shoulder == HexStrips::none ? infinite : static_cast<double>(shoulder - 1),
                    apex == HexStrips::none ? infinite : static_cast<double>(apex));
}

void TautSearch::Expansion::pushPart(View view, Whole row, int way, const Part &part)
{
    if (part.west > part.east + nearness)
        return;
    const double line = HexStrips::entryLine(row, way);
    if (part.endsWest)
        view.westCorner = see(view.root, part.west, line);
    if (part.endsEast)
        view.eastCorner = see(view.root, part.east, line);
    pushInterval(view, row, way, part.west, part.east);
}

void TautSearch::Expansion::lookAmongTips(Whole north)
{
    // The start's cell has one of the triangles; on a line the cell may be another's, whose triangle is free as well.
    const Whole south = north + 1;
    const double at = static_cast<double>(startX_);
    const Whole westNorth = strips_.blockedWest(north, HexStrips::lastCentreTo(north, at), -infinite);
    const Whole westSouth = strips_.blockedWest(south, HexStrips::lastCentreTo(south, at), -infinite);
    const Whole eastNorth = strips_.blockedEast(north, HexStrips::firstCentreFrom(north, at), infinite);
    const Whole eastSouth = strips_.blockedEast(south, HexStrips::firstCentreFrom(south, at), infinite);
    const Whole west = std::max(westNorth, westSouth);
    const Whole east = std::min(eastNorth, eastSouth);

    // a triangle of the northern row has its base on the northern line, and its tip on the southern one
    const View view = {0, start_, 0.0, 0.0, 0.0, 0.0};
    const auto look = [&](Whole row, int way)
    {
        const bool baseWest = west == (row == north ? westNorth : westSouth);
        const bool baseEast = east == (row == north ? eastNorth : eastSouth);
        const double line = HexStrips::entryLine(row, way);
        const double first = static_cast<double>(west + (baseWest ? 1 : 0));
        const double last = static_cast<double>(east - (baseEast ? 1 : 0));
        see(0, first, line);
        see(0, last, line);
        pushInterval(view, row, way, first, last);
    };
    look(north, -1);
    look(south, 1);
    if (goalAmongTips_ && goalNorthRow_ == north && west < goalX_ && goalX_ < east)
        pushGoal(0);
}

bool TautSearch::Expansion::seesGoalInRow(const View &view, double westWall, double eastWall, int way) const
{
    const double depth = (goal_.y - view.from.y) * way;
    if (depth < 0.0 || goal_.x < westWall - nearness || goal_.x > eastWall + nearness)
        return false;
    if (depth == 0.0)  // level with a root on the entry line or inside the row
        return goal_.x < view.from.x ? view.westSlope == -infinite : view.eastSlope == infinite;
    return goal_.x >= view.from.x + view.westSlope * depth - nearness &&
           goal_.x <= view.from.x + view.eastSlope * depth + nearness;
}

bool TautSearch::Expansion::isGoalAmongTips(Whole row, int way) const
{
    return goalAmongTips_ && goalNorthRow_ == std::min(row, row + way);
}

void TautSearch::Expansion::lookForGoalAmongTips(const View &view, Whole row, int way)
{
    const double exit = HexStrips::exitLine(row, way);
    const auto isInView = [&view](double x)
    {
        return x >= view.west - nearness && x <= view.east + nearness;
    };
    const double part = std::abs(exit - view.from.y) / std::abs(goal_.y - view.from.y);
    const double crossing = view.from.x + (goal_.x - view.from.x) * part;
    if (isInView(crossing) && reachesGoalAmongTips(crossing, row, way))
        pushGoal(view.root);
    // a pocket with the goal in it is none: the path may turn into it
    if (goalRow_ == row)
        for (const double tip : {static_cast<double>(goalX_ - 1), static_cast<double>(goalX_ + 1)})
            if (isInView(tip))
                see(view.root, tip, exit);
}

bool TautSearch::Expansion::reachesGoalAmongTips(double fromX, Whole row, int way) const
{
    const Whole first =
        goal_.x >= fromX ? HexStrips::cellEastOf(row, fromX + nearness) : HexStrips::cellWestOf(row, fromX - nearness);
    const double west = static_cast<double>(std::min(first, goalX_));
    const double east = static_cast<double>(std::max(first, goalX_));
    for (const Whole either : {row, row + way})
        if (strips_.blockedEast(either, HexStrips::firstCentreFrom(either, west), east) != HexStrips::none)
            return false;
    return true;
}

}  // namespace seahex
