#pragma once

#include "seahex/search/TautSearch.h"
#include "search/HexStrips.h"
#include "search/TautQueue.h"
#include "search/TautRoots.h"
#include "search/TautTurn.h"

namespace seahex
{

/// The state of a TautSearch and what it makes of a node.
///
/// Lengths and places are those of the frame of HexStrips. A row is crossed in two parts, from its entry line through
/// the rectangle of its free cells to its exit line, and on through the tips to the entry line of the next row.
class TautSearch::Expansion
{
public:
    using Whole = HexStrips::Whole;

    explicit Expansion(const HexOccupancy &occupancy) : occupancy_(occupancy), strips_(occupancy) {}

    void begin(const Point &start, const Point &goal, double bound);

    const HexOccupancy &occupancy() const { return occupancy_; }

    bool isFinished() const { return hasPath_ || queue_.empty(); }
    /// Takes a node from the queue and expands it. Not to be called when finished.
    void step();

    bool hasPath() const { return hasPath_; }
    double length() const { return length_ * strips_.unit(); }
    double lowerBound() const;
    std::vector<Point> path() const;
    std::uint64_t expanded() const { return expanded_; }
    std::size_t cornerCount() const { return roots_.size() == 0 ? 0 : roots_.size() - 1; }

private:
    /// Two places of a line no farther apart are one. Rays between corners meet a line in a corner, or stay away from
    /// it by the reciprocal of the rows between: 1e-6 on the largest lattices; rounding moves them by 1e-11 there.
    static constexpr double nearness = 1e-7;

    /// What a root sees between two rays, where they cross a line.
    struct View
    {
        std::uint32_t root;
        StripPoint from;  ///< the root
        double west;      ///< on the line
        double east;
        double westSlope;  ///< x for each y that the ray goes on
        double eastSlope;
        std::uint32_t westCorner = 0;  ///< the last corner known on the western ray; 0 for none
        std::uint32_t eastCorner = 0;
    };

    /// A part of what a view keeps on a line, and whether a corner of a blocked cell ends it or the view's own ray.
    struct Part
    {
        double west;
        double east;
        bool endsWest;
        bool endsEast;
    };

    void expandStart();
    void expandCorner(std::uint32_t root);
    void expandTip(std::uint32_t root, const TautTurn &turn, double dx, double dy);
    void expandInterval(const TautNode &node);

    /// From the entry line of a row, or from a root inside it, to the row's exit line and beyond.
    /// @param view  its interval on the entry line, or at the root
    void crossRow(const View &view, Whole row, int way);
    /// From the exit line of a row to the entry line of the next.
    /// @param view  its interval on the exit line
    void crossTips(View view, Whole row, int way);
    /// All that is seen from a start among the tips of two rows, the northern one given. On a line between strips too:
    /// from there all of the next row is seen, as rays through an interval of the same line are level.
    void lookAmongTips(Whole north);

    /// Where what lies west of a place on the exit line cuts off, on the entry line of the next row, what is seen
    /// through the tips between: at the shoulder of a blocked cell of the next row, or the tip of one of this row.
    /// @param tip  the first cell of the next row west of the place
    /// @param ray  look no farther than this
    /// @return minus infinity if nothing does
    double westEndAmongTips(Whole row, Whole next, double place, Whole tip, double ray) const;
    /// The same in the east; infinity if nothing does.
    double eastEndAmongTips(Whole row, Whole next, double place, Whole tip, double ray) const;

    bool seesGoalInRow(const View &view, double westWall, double eastWall, int way) const;
    /// Does the goal lie among the tips of a row and the next?
    bool isGoalAmongTips(Whole row, int way) const;
    void lookForGoalAmongTips(const View &view, Whole row, int way);
    /// Is there nothing but free tips between a place on a row's exit line and the goal among them?
    bool reachesGoalAmongTips(double fromX, Whole row, int way) const;

    /// Queues a part of a view on the entry line of a row, and the corners that end it.
    void pushPart(View view, Whole row, int way, const Part &part);
    /// Queues an interval of a view on the entry line of a row.
    void pushInterval(const View &view, Whole row, int way, double west, double east);
    void pushGoal(std::uint32_t root);
    /// Queues a corner that a root sees if a taut path can turn there and no way as short is known.
    /// @return its number if any way to it is known, else 0
    std::uint32_t see(std::uint32_t root, double x, double y);
    /// Does a corner at an end of the interval reach all of it sooner than the root? Root, corner and interval span a
    /// triangle that is free, and the corner's lead is least at the far end.
    bool isDominated(const TautNode &node) const;

    double toGoal(double x, double y) const { return stripNorm(goal_.x - x, goal_.y - y); }

    const HexOccupancy &occupancy_;
    HexStrips strips_;
    TautQueue queue_;
    TautRoots roots_;
    StripPoint start_;
    StripPoint goal_;
    Point planeStart_;
    Point planeGoal_;
    Whole startX_ = 0;   // of the cell
    Whole goalRow_ = 0;  // of the cell
    Whole goalX_ = 0;
    bool goalAmongTips_ = false;
    Whole goalNorthRow_ = 0;  // the northern one of the two whose tips they are; else the row of the rectangle
    double bound_ = 0.0;
    double least_ = 0.0;
    double length_ = 0.0;
    bool hasPath_ = false;
    std::uint32_t last_ = 0;  // the root that sees the goal
    std::uint64_t expanded_ = 0;
};

}  // namespace seahex
