#pragma once

#include <seahex/geometry/Lattice.h>
#include <seahex/geometry/Point.h>

#include <array>
#include <limits>

namespace seahex
{

/// Cuts a straight segment into pieces that lie in one cell each: what an integral along the line needs.
///
/// The edges of all cells lie on the lines of a few families, on which a coordinate is a whole number: of hexagons
/// three (2 x, -x - y and y - x, with x in pitches and y in sides, southward, from a centre), of squares two (columns
/// and rows). Between two crossings of such lines the segment is in one cell. A segment that runs along a line of a
/// family, within the traversal's tolerance, may have an edge under it: each piece then belongs half to the cell on its
/// left and half to the one on its right, which may be the same.
///
/// The lengths add up to that of the segment, and are exact but for rounding. The pieces are the same, in the same
/// order, for (a, b) and (b, a). Time: linear in the pieces, at most four or so to a hexagon, two to a square. Nothing
/// is allocated.
class Chords
{
public:
    /// @param a, b  finite, and at most 2^40 cells from the lattice's origin
    Chords(const Lattice &lattice, const Point &a, const Point &b);

    /// Goes on to the next piece (before the first one at the beginning). @return false if there is none
    bool next();

    /// The piece's length, > 0.
    double length() const { return pieceLength_; }
    OffsetCoord left() const { return left_; }
    OffsetCoord right() const { return right_; }

private:
    /// The segment seen by one family of lines; as it is, a segment that crosses none.
    struct Crossings
    {
        double begin = 0.0;                                   // the family's coordinate at the beginning
        double slope = 0.0;                                   // by how much it grows from end to end
        double line = 0.0;                                    // the line to be crossed next
        double at = std::numeric_limits<double>::infinity();  // where: 0 is the beginning of the segment, 1 its end

        static Crossings between(double begin, double end);
        void advance();
    };

    Lattice lattice_;
    Point origin_;  // of the two ends the northern one; of level ones the eastern
    Point vector_;
    double length_;
    std::array<Crossings, 3> families_;
    bool alongLine_ = false;
    double reached_ = 0.0;
    double pieceLength_ = 0.0;
    OffsetCoord left_;
    OffsetCoord right_;
};

/// Calls visit(cell, length) for pieces of the segment from a to b; see Chords. A cell may come several times.
template <class Visit>
void forEachChord(const Lattice &lattice, const Point &a, const Point &b, Visit &&visit)
{
    for (Chords chords(lattice, a, b); chords.next();)
        if (chords.left() == chords.right())
        {
            visit(chords.left(), chords.length());
        }
        else
        {
            visit(chords.left(), 0.5 * chords.length());
            visit(chords.right(), 0.5 * chords.length());
        }
}

}  // namespace seahex
