#include "seahex/geometry/Chords.h"

#include "seahex/geometry/SegmentSpans.h"

#include <algorithm>
#include <cmath>

namespace seahex
{
namespace
{

/// A point in the coordinates of the families of lines; of squares the first two count.
std::array<double, 3> familyCoordinates(const Lattice &lattice, const Point &p)
{
    const double x = (p.x() - lattice.northWest().x()) / lattice.pitch();
    const double south = lattice.northWest().y() - p.y();
    const HexLattice *hexagons = lattice.hexagons();
    if (hexagons == nullptr)
        return {x, south / lattice.pitch(), 0.0};
    const double y = south / hexagons->side() - 1.0;
    return {2.0 * x, -x - y, y - x};
}

}  // namespace

Chords::Crossings Chords::Crossings::between(double begin, double end)
{
    Crossings crossings;
    if (begin == end)
        return crossings;
    crossings.begin = begin;
    crossings.slope = end - begin;
    crossings.line = end > begin ? std::floor(begin) : std::ceil(begin);
    crossings.advance();
    return crossings;
}

void Chords::Crossings::advance()
{
    line += slope > 0.0 ? 1.0 : -1.0;
    at = (line - begin) / slope;
}

Chords::Chords(const Lattice &lattice, const Point &a, const Point &b) : lattice_(lattice)
{
    // One order of the ends for both directions, so that all arithmetic below is the same.
    const bool swapped = b.y() > a.y() || (b.y() == a.y() && b.x() > a.x());
    origin_ = swapped ? b : a;
    const Point &end = swapped ? a : b;
    vector_ = end - origin_;
    length_ = vector_.norm();

    // Lines of a family lie half a pitch apart on hexagons, a pitch on squares.
    const bool isHex = lattice.hexagons() != nullptr;
    const std::size_t familyCount = isHex ? 3 : 2;
    const double tolerance = traversalTolerance(lattice, a, b) / (isHex ? 0.5 * lattice.pitch() : lattice.pitch());
    const std::array<double, 3> first = familyCoordinates(lattice, origin_);
    const std::array<double, 3> last = familyCoordinates(lattice, end);
    for (std::size_t k = 0; k < familyCount; ++k)
    {
        const double line = std::round(first[k]);
        alongLine_ = alongLine_ || (std::abs(first[k] - line) <= tolerance && std::abs(last[k] - line) <= tolerance);
        families_[k] = Crossings::between(first[k], last[k]);
    }
    if (length_ == 0.0)
        reached_ = 1.0;
}

bool Chords::next()
{
    while (reached_ < 1.0)
    {
        const double from = reached_;
        reached_ = std::min({1.0, families_[0].at, families_[1].at, families_[2].at});
        for (Crossings &family : families_)
            if (family.at <= reached_)
                family.advance();
        // Where lines of two families cross, rounding may put the second crossing before the first.
        reached_ = std::max(reached_, from);
        pieceLength_ = (reached_ - from) * length_;
        if (!(pieceLength_ > 0.0))
            continue;
        const Point middle = origin_ + 0.5 * (from + reached_) * vector_;
        // Lines of a family meet others at 60 degrees or more, so this far aside one is in no other cell than beside
        // the piece.
        const Point aside = 0.25 * (reached_ - from) * Point(-vector_.y(), vector_.x());
        left_ = lattice_.cellAt(alongLine_ ? middle + aside : middle);
        right_ = alongLine_ ? lattice_.cellAt(middle - aside) : left_;
        return true;
    }
    return false;
}

}  // namespace seahex
