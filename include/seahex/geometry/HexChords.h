#pragma once

#include <seahex/geometry/HexCoord.h>
#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/Point.h>

#include <array>

namespace seahex
{

/// Cuts a straight segment into pieces that lie in one cell each: what an integral along the line needs.
///
/// The edges of all hexagons lie on the lines of three families, on which 2 x, -x - y and y - x are whole numbers (x in
/// pitches and y in sides, southward, from a centre). Between two crossings of such lines the segment is in one cell.
/// A segment that runs along a line of a family, within the traversal's tolerance, may have an edge under it: each
/// piece then belongs half to the cell on its left and half to the one on its right, which may be the same.
///
/// The lengths add up to that of the segment, and are exact but for rounding. The pieces are the same, in the same
/// order, for (a, b) and (b, a). Time: linear in the pieces, at most four or so to a cell. Nothing is allocated.
class HexChords
{
public:
    /// @param a, b  finite, and at most 2^40 cells from the lattice's origin
    HexChords(const HexLattice &lattice, const Point &a, const Point &b);

    /// Goes on to the next piece (before the first one at the beginning). @return false if there is none
    bool next();

    /// The piece's length, > 0.
    double length() const { return pieceLength_; }
    HexCoord left() const { return left_; }
    HexCoord right() const { return right_; }

private:
    /// The segment seen by one family of lines.
    struct Crossings
    {
        double begin;  // the family's coordinate at the beginning
        double slope;  // by how much it grows from end to end
        double line;   // the line to be crossed next
        double at;     // where: 0 is the beginning of the segment, 1 its end

        static Crossings between(double begin, double end);
        void advance();
    };

    HexLattice lattice_;
    Point origin_;  // of the two ends the northern one; of level ones the eastern
    Point vector_;
    double length_;
    std::array<Crossings, 3> families_;
    bool alongLine_ = false;
    double reached_ = 0.0;
    double pieceLength_ = 0.0;
    HexCoord left_;
    HexCoord right_;
};

/// Calls visit(cell, length) for pieces of the segment from a to b; see HexChords. A cell may come several times.
template <class Visit>
void forEachChord(const HexLattice &lattice, const Point &a, const Point &b, Visit &&visit)
{
    for (HexChords chords(lattice, a, b); chords.next();)
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
