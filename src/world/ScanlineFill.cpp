#include "seahex/world/ScanlineFill.h"

#include <algorithm>
#include <cmath>

namespace seahex
{

template <class Visit>
void ScanlineFill::forEachCrossing(const Ring &ring, Visit &&visit) const
{
    const double rowStep = lattice_.rowStep();
    const double firstY = lattice_.halfHeight();
    const Point origin = lattice_.northWest();
    const auto rowCount = static_cast<double>(lattice_.rows());
    // Each vertex is turned into a row number once and compared as such, so that the two edges that meet there agree.
    const auto rowOf = [&](const Point &p)
    {
        return std::ceil((origin.y() - p.y() - firstY) / rowStep);
    };
    double previousRow = ring.empty() ? 0.0 : rowOf(ring.front());
    for (std::size_t i = 1; i < ring.size(); ++i)
    {
        const double row = rowOf(ring[i]);
        const double from = std::min(previousRow, row);
        const double to = std::max(previousRow, row);
        const int winding = row > previousRow ? 1 : -1;
        previousRow = row;
        if (from == to)
            continue;
        const Point &a = ring[i - 1];
        const Point &b = ring[i];
        const double slope = (b.x() - a.x()) / (b.y() - a.y());
        const auto firstRow = static_cast<std::int64_t>(std::max(from, 0.0));
        const auto endRow = static_cast<std::int64_t>(std::min(to, rowCount));
        for (std::int64_t r = firstRow; r < endRow; ++r)
        {
            const double y = origin.y() - firstY - rowStep * static_cast<double>(r);
            const double x = std::clamp(a.x() + (y - a.y()) * slope, std::min(a.x(), b.x()), std::max(a.x(), b.x()));
            visit(r, x - origin.x(), winding);
        }
    }
}

void ScanlineFill::countRing(const Ring &ring)
{
    forEachCrossing(ring, [this](std::int64_t row, double, int) { ++rowStart_[static_cast<std::size_t>(row)]; });
}

void ScanlineFill::placeRing(const Ring &ring, int orientation)
{
    forEachCrossing(ring,
                    [this, orientation](std::int64_t row, double x, int winding) {
                        crossings_[--rowStart_[static_cast<std::size_t>(row)]] = {x, winding * orientation};
                    });
}

void ScanlineFill::fill(const Polygon &polygon, CellBits &bits)
{
    // Counting sort by row: count, sum up, place from the end; then sort the few crossings of each row by x.
    const std::int64_t rows = lattice_.rows();
    rowStart_.assign(static_cast<std::size_t>(rows) + 1, 0);
    countRing(polygon.outer());
    for (const Ring &hole : polygon.inners())
        countRing(hole);
    std::uint32_t total = 0;
    for (std::uint32_t &count : rowStart_)
        count = total += count;
    if (total == 0)
        return;
    crossings_.resize(total);
    placeRing(polygon.outer(), signedArea(polygon.outer()) < 0.0 ? -1 : 1);
    for (const Ring &hole : polygon.inners())
        placeRing(hole, signedArea(hole) < 0.0 ? 1 : -1);

    const double perColumn = 1.0 / lattice_.pitch();
    for (std::int64_t row = 0; row < rows; ++row)
    {
        const auto begin = crossings_.begin() + rowStart_[static_cast<std::size_t>(row)];
        const auto end = crossings_.begin() + rowStart_[static_cast<std::size_t>(row) + 1];
        if (begin == end)
            continue;
        std::sort(begin, end, [](const Crossing &a, const Crossing &b) { return a.x < b.x; });
        const double first = lattice_.firstColumn(row);
        int winding = 0;
        for (auto crossing = begin; crossing + 1 < end; ++crossing)
        {
            winding += crossing->winding;
            if (winding != 0)
                bits.setSpan(row, static_cast<std::int64_t>(std::ceil(crossing->x * perColumn - first)),
                             static_cast<std::int64_t>(std::floor((crossing + 1)->x * perColumn - first)));
        }
    }
}

}  // namespace seahex
