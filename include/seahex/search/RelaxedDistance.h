#pragma once

#include <seahex/geometry/HexLines.h>
#include <seahex/world/Occupancy.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace seahex
{

/// A lower bound of the length of a path to one goal that knows of obstacles: the exact distance in a relaxed world
/// that is easy to search, because in it every path leads straight on from line to line.
///
/// **The relaxed world.** Take the lines of cells (HexLines) that lie across the way from start to goal, and count them
/// from the goal's. From a cell on line n a vessel may go (aside: measured along the line, in pitches)
///
///     along the line, through anything                                    at 1 a pitch
///     to a free cell of line n - 1, 1/2 aside                             at 1
///     to a free cell of line n - 1, 3/2 aside                             at root 3; root 7 - 1 for 3 rings    rings >
///     1 to a free cell of line n - 2, straight across, between free cells   at root 3                            rings
///     > 1 to a free cell of line n - 3, 1/2 aside, over free cells            at root 7 rings > 2
///
/// and on the goal's line, all of whose cells count as free, along it to the goal. h(u) is the least cost of that.
/// Islands, bays and narrows across the way hold a path up there as they do in truth; what is lost is what a way along
/// the lines, or back, would have to go round.
///
/// **Consistent**, and so admissible: h(u) <= c(u, v) + h(v) for every valid jump from u to v. Let |x| be the norm that
/// the moves span in all directions: 1 a pitch along a line, and nowhere more than the jumps cost.
///
/// *A jump along u's line or towards the goal's* is one of the moves, or several over cells that it touches, which are
/// free, at the same cost or less (root 7 = 1 + (root 7 - 1)).
///
/// *A jump away from the goal's line.* Where the best way from v enters u's line at a cell p, h(u) <= |u - p| + h(p) <=
/// |u - v| + |v - p| + h(p) <= c(u, v) + h(v). Elsewhere one of its moves, from a to b at cost m, passes over u's line
/// in a point x. As |u - x| <= c(u, v) + |v - a| + |a - x|, it suffices that from u to b it costs at most
/// |u - x| + m - |a - x|. Go from u along the line to the last centre before x, d away from x, and from there to b in k
/// steps of cost 1, over cells that the move touches: k - d <= m - |a - x| remains to be seen. For the move of two
/// lines it says 1 - 1/2 <= root 3 / 2. The move of three lines passes one line between centres at 1/3 and 2/3, from
/// both of which it is 2 steps (2 - 1/3 <= 2/3 root 7), and the other the same way, 1 step from b (1 - 1/3 <= root 7 /
/// 3).
///
/// *A jump across the goal's line*, in x: the same steps lead from the centre beside x, on the goal's side, to u, and
/// where jump and line meet in the middle of root 7, there is one step on one side of x, and a move 3/2 aside on the
/// other.
///
/// **Exact without a queue.** One pass over each line, from the goal's outwards, finds all h. For the step along a line
/// it would take a second one, but that is never the best but over blocked cells, where h grows by 1 from both ends:
/// from the neighbours of a cell where a move of two or three lines begins, single moves over the cells that it touches
/// cost no more than that step and the move. (For this 3/2 aside must cost root 7 - 1, not root 3, with 3 rings.)
///
/// Lines are passed when they are first asked for: a few nanoseconds and 8 bytes a cell.
class RelaxedDistance
{
public:
    /// @param occupancy  of hexagons
    /// @param rings  1, 2 or 3: the jumps whose Euclidean lengths, in pitches, make up the path; 1 for the number of
    ///               steps D of [Cheng2020] eq. 4, which no ring shortens
    RelaxedDistance(std::shared_ptr<const Occupancy> occupancy, HexCoord start, HexCoord goal, int rings);
    ~RelaxedDistance();
    RelaxedDistance(const RelaxedDistance &) = delete;
    RelaxedDistance &operator=(const RelaxedDistance &) = delete;

    HexCoord goal() const { return lines_.origin(); }

    /// Passes one line more on the way to the start's. @return false if all of them were
    bool passNextLine();

    /// h of a free cell; infinity if no path leads from there to the goal.
    double operator()(HexCoord cell);

private:
    class Side;

    Side &sideOf(std::int64_t line) { return *sides_[line < 0 ? 1 : 0]; }

    std::shared_ptr<const Occupancy> occupancy_;
    HexLines lines_;
    std::int64_t startLine_;
    std::array<std::unique_ptr<Side>, 2> sides_;
};

}  // namespace seahex
