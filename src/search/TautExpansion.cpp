#include "search/TautExpansion.h"

#include "seahex/world/SegmentValidity.h"

#include <algorithm>
#include <cmath>
#include <limits>

// The nodes of a TautSearch: how they come into the queue, and what becomes of them.

namespace seahex
{
namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A start or goal so near to a line between strips is put onto it.
double ontoLine(double y)
{
    const double whole = std::round(y);
    return std::abs(y - whole) < 1e-9 ? whole : y;
}

}  // namespace

void TautSearch::Expansion::begin(const Point &start, const Point &goal, double bound)
{
    queue_.clear();
    expanded_ = 0;
    hasPath_ = false;
    length_ = infinite;
    least_ = 0.0;
    bound_ = bound / strips_.unit();
    planeStart_ = start;
    planeGoal_ = goal;
    roots_.begin(0.0, 0.0);
    if (!isFree(occupancy_, start, start) || !isFree(occupancy_, goal, goal))
        return;
    const OffsetCoord startCell = toOffset(occupancy_.lattice().cellAt(start));
    const OffsetCoord goalCell = toOffset(occupancy_.lattice().cellAt(goal));
    startX_ = HexStrips::centre(startCell);
    goalRow_ = goalCell.row;
    goalX_ = HexStrips::centre(goalCell);
    start_ = strips_.fromPlane(start);
    goal_ = strips_.fromPlane(goal);
    start_.y = ontoLine(start_.y);
    goal_.y = ontoLine(goal_.y);
    const Whole third = HexStrips::floor(goal_.y / 3.0);
    goalAmongTips_ = goal_.y < static_cast<double>(3 * third + 1);
    goalNorthRow_ = goalAmongTips_ ? third - 1 : third;
    roots_.begin(start_.x, start_.y);
    expandStart();
}

double TautSearch::Expansion::lowerBound() const
{
    if (hasPath_)
        return length();
    const double least = queue_.empty() ? bound_ : std::min(bound_, std::max(least_, queue_.least()));
    return least * strips_.unit();
}

std::vector<Point> TautSearch::Expansion::path() const
{
    std::vector<Point> points;
    if (!hasPath_)
        return points;
    points.push_back(planeGoal_);
    for (std::uint32_t root = last_; root != 0; root = roots_[root].before)
        points.push_back(strips_.toPlane({roots_[root].x, roots_[root].y}));
    points.push_back(planeStart_);
    std::reverse(points.begin(), points.end());
    return points;
}

void TautSearch::Expansion::step()
{
    const TautNode node = queue_.take();
    least_ = std::max(least_, node.estimate);
    ++expanded_;
    switch (node.kind())
    {
        case TautNode::Kind::Southward:
        case TautNode::Kind::Northward:
            if (!isDominated(node))
                expandInterval(node);
            break;
        case TautNode::Kind::Corner:
            if (node.west <= roots_[node.root].length)
                expandCorner(node.root);
            break;
        case TautNode::Kind::Goal:
            hasPath_ = true;
            last_ = node.root;
            length_ = roots_[node.root].length + toGoal(roots_[node.root].x, roots_[node.root].y);
            break;
    }
}

void TautSearch::Expansion::expandInterval(const TautNode &node)
{
    const int way = node.kind() == TautNode::Kind::Southward ? 1 : -1;
    const TautRoots::Root &root = roots_[node.root];
    const double depth = std::abs(HexStrips::entryLine(node.row(), way) - root.y);
    crossRow({node.root,
              {root.x, root.y},
              node.west,
              node.east,
              (node.west - root.x) / depth,
              (node.east - root.x) / depth,
              node.westCorner,
              node.eastCorner},
             node.row(), way);
}

void TautSearch::Expansion::expandStart()
{
    const Whole third = HexStrips::floor(start_.y / 3.0);
    if (start_.y <= static_cast<double>(3 * third + 1))
        return lookAmongTips(third - 1);
    const View all = {0, start_, start_.x, start_.x, -infinite, infinite};
    crossRow(all, third, 1);
    crossRow(all, third, -1);
}

void TautSearch::Expansion::expandCorner(std::uint32_t number)
{
    const TautRoots::Root root = roots_[number];
    const TautRoots::Root &before = roots_[root.before];
    const double dx = root.x - before.x;
    const double dy = root.y - before.y;
    const TautTurn turn(strips_, {root.x, root.y}, dx, dy);
    const int way = turn.way;
    View view = {number, {root.x, root.y}, root.x, root.x, 0.0, 0.0};
    switch (turn.along)
    {
        case TautTurn::Along::Tip:
            expandTip(number, turn, dx, dy);
            break;
        case TautTurn::Along::Upright:
        {
            const double ahead = dx / std::abs(dy);
            view.westSlope = std::min(ahead, 0.0);
            view.eastSlope = std::max(ahead, 0.0);
            crossRow(view, turn.row, way);
            break;
        }
        case TautTurn::Along::Slanted:
        {
            // the cell ahead stands on the corner with its tip, and all that is seen of it is seen through its base
            const double ahead = root.x + dx / std::abs(dy);
            const double end = root.x + turn.side;
            const double line = root.y - way;
            see(number, end, line);
            if (isGoalAmongTips(turn.row, -way) && goalRow_ == turn.row - way && goalX_ == turn.x)
                pushGoal(number);
            pushInterval(view, turn.row - way, -way, std::min(ahead, end), std::max(ahead, end));
            break;
        }
        case TautTurn::Along::Nothing:
            break;
    }
}

void TautSearch::Expansion::expandTip(std::uint32_t number, const TautTurn &turn, double dx, double dy)
{
    const TautRoots::Root root = roots_[number];
    const int way = turn.way;
    const int side = turn.side;
    const double along = dy * way;  // towards the row
    View view = {number, {root.x, root.y}, root.x, root.x, 0.0, 0.0};
    if (along > 0.0)
    {
        view.westSlope = side > 0 ? dx / along : -infinite;
        view.eastSlope = side > 0 ? infinite : dx / along;
        crossRow(view, turn.row, way);
    }

    // Beside the blocked tip, away from the row: up to the level ray, or to the way the path came.
    const Whole row = turn.row;
    const Whole next = row - way;
    const double line = root.y - way;
    const double reach = along < 0.0 ? root.x + dx / -along : side * infinite;
    const bool seesLevel = along >= 0.0;
    const Whole tip = side > 0 ? strips_.blockedEast(next, turn.x + 2, reach + nearness + 1.0)
                               : strips_.blockedWest(next, turn.x - 2, reach - nearness - 1.0);
    const Whole wall = side > 0 ? strips_.blockedEast(row, turn.x + 1, reach + nearness)
                                : strips_.blockedWest(row, turn.x - 1, reach - nearness);
    const bool endsAtTip = tip != HexStrips::none && (wall == HexStrips::none || side * (wall - tip) > 0);
    if (seesLevel && endsAtTip)
        see(number, static_cast<double>(tip), root.y);
    see(number, root.x + side, line);
    double end = reach;
    if (endsAtTip || wall != HexStrips::none)
    {
        const double limit = static_cast<double>(endsAtTip ? tip - side : wall);
        if (side * (reach - limit) >= -nearness)
        {
            end = limit;
            see(number, limit, line);
        }
    }
    if (isGoalAmongTips(row, -way) && side * (goalX_ - turn.x) > 0 && reachesGoalAmongTips(root.x, row, -way))
        pushGoal(number);
    if (side > 0)
        pushInterval(view, next, -way, root.x + 1.0, end);
    else
        pushInterval(view, next, -way, end, root.x - 1.0);
}

void TautSearch::Expansion::pushInterval(const View &view, Whole row, int way, double west, double east)
{
    if (east - west <= nearness)
        return;
    // a path that comes back to the goal on this side of the line is as long as one to the goal's mirror image
    const double line = HexStrips::entryLine(row, way);
    const double depth = std::abs(line - view.from.y);
    const double beyond = std::abs(goal_.y - line);
    const double crossing = view.from.x + (goal_.x - view.from.x) * depth / (depth + beyond);
    const double rest = crossing < west   ? stripNorm(west - view.from.x, depth) + stripNorm(goal_.x - west, beyond)
                        : crossing > east ? stripNorm(east - view.from.x, depth) + stripNorm(goal_.x - east, beyond)
                                          : stripNorm(goal_.x - view.from.x, depth + beyond);
    const double estimate = roots_[view.root].length + rest;
    if (estimate < bound_)
        queue_.push({estimate, west, east, view.root,
                     TautNode::pack(row, way > 0 ? TautNode::Kind::Southward : TautNode::Kind::Northward),
                     view.westCorner, view.eastCorner});
}

void TautSearch::Expansion::pushGoal(std::uint32_t number)
{
    const TautRoots::Root &root = roots_[number];
    const double estimate = root.length + toGoal(root.x, root.y);
    if (estimate < bound_)
        queue_.push({estimate, 0.0, 0.0, number, TautNode::pack(0, TautNode::Kind::Goal), 0, 0});
}

std::uint32_t TautSearch::Expansion::see(std::uint32_t number, double x, double y)
{
    const TautRoots::Root root = roots_[number];
    const double dx = x - root.x;
    const double dy = y - root.y;
    const TautTurn turn(strips_, {x, y}, dx, dy);
    if (turn.along == TautTurn::Along::Nothing || turn.isPocket(strips_, dx, dy, goalRow_, goalX_))
        return roots_.find(x, y);
    const double length = root.length + stripNorm(dx, dy);
    const double estimate = length + toGoal(x, y);
    if (estimate >= bound_)
        return roots_.find(x, y);
    const auto [corner, improved] = roots_.improve(x, y, length, number);
    if (improved)
        queue_.push({estimate, length, 0.0, corner, TautNode::pack(0, TautNode::Kind::Corner), 0, 0});
    return corner;
}

bool TautSearch::Expansion::isDominated(const TautNode &node) const
{
    const int way = node.kind() == TautNode::Kind::Southward ? 1 : -1;
    const double line = HexStrips::entryLine(node.row(), way);
    const TautRoots::Root &root = roots_[node.root];
    // by more than rounding, or two ways of one length could drop each other
    const auto reaches = [&](std::uint32_t number, double x)
    {
        const TautRoots::Root &corner = roots_[number];
        return corner.length + stripNorm(x - corner.x, line - corner.y) <
               (root.length + stripNorm(x - root.x, line - root.y)) * (1.0 - 1e-12) - 1e-9;
    };
    return (node.westCorner != 0 && reaches(node.westCorner, node.east)) ||
           (node.eastCorner != 0 && reaches(node.eastCorner, node.west));
}

}  // namespace seahex
