#include "seahex/geometry/HexChords.h"

#include "seahex/geometry/HexTraversal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seahex
{

HexChords::Crossings HexChords::Crossings::between(double begin, double end)
{
    if (begin == end)
        return {begin, 0.0, begin, std::numeric_limits<double>::infinity()};
    Crossings crossings{begin, end - begin, end > begin ? std::floor(begin) : std::ceil(begin), 0.0};
    crossings.advance();
    return crossings;
}

void HexChords::Crossings::advance()
{
    line += slope > 0.0 ? 1.0 : -1.0;
    at = (line - begin) / slope;
}

HexChords::HexChords(const HexLattice &lattice, const Point &a, const Point &b) : lattice_(lattice)
{
    // One order of the ends for both directions, so that all arithmetic below is the same.
    const bool swapped = b.y() > a.y() || (b.y() == a.y() && b.x() > a.x());
    origin_ = swapped ? b : a;
    const Point &end = swapped ? a : b;
    vector_ = end - origin_;
    length_ = vector_.norm();

    const double tolerance = traversalTolerance(lattice, a, b) / (0.5 * lattice.pitch());
    const auto coordinates = [&lattice](const Point &p)
    {
        const double x = (p.x() - lattice.northWest().x()) / lattice.pitch();
        const double y = (lattice.northWest().y() - p.y()) / lattice.side() - 1.0;
        return std::array<double, 3>{2.0 * x, -x - y, y - x};
    };
    const std::array<double, 3> first = coordinates(origin_);
    const std::array<double, 3> last = coordinates(end);
    for (std::size_t k = 0; k < 3; ++k)
    {
        const double line = std::round(first[k]);
        alongLine_ = alongLine_ || (std::abs(first[k] - line) <= tolerance && std::abs(last[k] - line) <= tolerance);
        families_[k] = Crossings::between(first[k], last[k]);
    }
    if (length_ == 0.0)
        reached_ = 1.0;
}

bool HexChords::next()
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
        // Lines of a family meet others at 60 degrees, so this far aside one is in no other cell than beside the piece.
        const Point aside = 0.25 * (reached_ - from) * Point(-vector_.y(), vector_.x());
        left_ = lattice_.cellAt(alongLine_ ? middle + aside : middle);
        right_ = alongLine_ ? lattice_.cellAt(middle - aside) : left_;
        return true;
    }
    return false;
}

}  // namespace seahex
