#pragma once

#include <seahex/geometry/Point.h>

#include <cstddef>
#include <vector>

namespace seahex
{

/// What turning costs, in the unit in which a search counts length.
struct TurnCosts
{
    double perTurn = 0.0;    ///< for each change of course, however small
    double perRadian = 0.0;  ///< for each radian of it
};

/// What jumps, and the turns between them, cost at the least from a cell to a goal where nothing is in the way: the
/// bound of a turn-aware search.
///
/// The relaxed problem. Let any non-negative multiple of a jump be a leg, at that multiple of its cost; costs of jumps
/// are a norm of their vectors. Given are the difference d to the goal and the present heading, a jump h. Let u and v
/// be the two jump directions next to d, v the one farther from h (u = v if d is a jump's own direction), and |d| the
/// norm that all jumps span (LatticeNorm). Then the least cost is
///
///     no turn    |d|                                        if d is h's direction, or nothing
///     else       perRadian angle(h, v) + least of
///                    perTurn + a |h| + b |v|                one turn, d = a h + b v
///                    2 perTurn + |d|                        two turns, d = a u + b v
///
/// Proof. *Angle:* legs that all lie on the near side of d, or short of it, do not add up to d, so some heading is at d
/// or beyond; the first that there is, v, is at most half a turn away, and to go round the other way is farther.
/// *One turn:* any j in the place of v lies beyond it, so v is a sum of multiples of h and j, and by the triangle
/// inequality no dearer. *More turns* can't be shorter than |d|, which two turns reach: to u, and on to v. The one turn
/// and the two turns both turn by angle(h, v), so the least of the sum is the sum of the leasts.
///
/// Every path of jumps among obstacles is also one of the relaxed problem, so the bound is admissible; it is the exact
/// cost of that problem, so no jump or turn lowers it by more than it costs: it is consistent.
class TurnBound
{
public:
    /// @param jumps  vectors in the plane, in any unit: with each also its opposite, and not all on one line
    /// @param costs  of the jumps; as said, a norm of their vectors
    TurnBound(std::vector<Point> jumps, std::vector<double> costs, const TurnCosts &turns);

    /// The angle between two jumps, radians in [0, pi]; exactly 0 for the same direction.
    double angle(std::size_t a, std::size_t b) const { return angles_[a * jumps_.size() + b]; }

    /// What it costs to turn from one jump to another; 0 for the same direction.
    double turn(std::size_t from, std::size_t to) const { return turns_[from * jumps_.size() + to]; }

    /// What the bound needs to know of a difference, whatever the heading.
    struct Approach
    {
        Point difference = Point::Zero();
        double norm = 0.0;
        bool isNothing = true;  ///< there is no way to go
        std::size_t right = 0;  ///< the last jump direction counter-clockwise from east up to the difference's
        std::size_t left = 0;   ///< the next; the same where the difference has a jump's direction
    };

    /// @param difference  to the goal, a sum of jumps
    /// @param norm  least cost of a chain of the jumps that adds up to the difference, turns free
    Approach approach(const Point &difference, double norm) const;

    /// @param heading  a jump; any larger number where a path has not begun, so that its first leg is no turn
    double operator()(const Approach &approach, std::size_t heading) const;

private:
    std::vector<Point> jumps_;
    std::vector<double> costs_;
    TurnCosts costOf_;
    double parallel_;  // smaller cross products are rounding
    std::vector<double> angles_;
    std::vector<double> turns_;
    std::vector<std::size_t> around_;  // one jump of each direction, counter-clockwise from east
};

}  // namespace seahex
