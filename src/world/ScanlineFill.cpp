#include "seahex/world/ScanlineFill.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seahex
{

ScanlineFill::ScanlineFill(const Lattice &lattice)
    : lattice_(lattice), firstCentre_(lattice.northWest().x(), lattice.northWest().y() - lattice.halfHeight()),
      rowsPerUnit_(1.0 / lattice.rowStep())
{
}

/// The first row whose centres lie at the point or south of it. Beyond the lattice it is only known to be beyond.
inline double ScanlineFill::rowOf(const Point &p) const
{
    const double row = std::clamp((firstCentre_.y() - p.y()) * rowsPerUnit_, 0.0, static_cast<double>(lattice_.rows()));
    const auto whole = static_cast<double>(static_cast<std::int64_t>(row));  // std::ceil is a call on plain x86-64
    return whole < row ? whole + 1.0 : whole;
}

void ScanlineFill::limitRows(const Polygon &polygon)
{
    double north = -std::numeric_limits<double>::infinity();
    double south = -north;
    const auto look = [&north, &south](const Ring &ring)
    {
        for (const Point &p : ring)
        {
            north = std::max(north, p.y());
            south = std::min(south, p.y());
        }
    };
    look(polygon.outer());
    for (const Ring &hole : polygon.inners())
        look(hole);
    begin_ = end_ = 0;
    if (north < south)
        return;
    begin_ = static_cast<std::int64_t>(rowOf(Point(0.0, north)));
    end_ = static_cast<std::int64_t>(rowOf(Point(0.0, south)));
}

template <class Visit>
void ScanlineFill::forEachCrossing(const Ring &ring, Visit &&visit) const
{
    const double rowStep = lattice_.rowStep();
    // Each vertex is turned into a row number once and compared as such, so that the two edges that meet there agree.
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
        const auto firstRow = static_cast<std::int64_t>(from);
        const auto endRow = static_cast<std::int64_t>(to);
        for (std::int64_t r = firstRow; r < endRow; ++r)
        {
            const double y = firstCentre_.y() - rowStep * static_cast<double>(r);
            const double x = std::clamp(a.x() + (y - a.y()) * slope, std::min(a.x(), b.x()), std::max(a.x(), b.x()));
            visit(static_cast<std::size_t>(r - begin_), x - firstCentre_.x(), winding);
        }
    }
}

void ScanlineFill::countRing(const Ring &ring)
{
    forEachCrossing(ring, [this](std::size_t row, double, int) { ++rowStart_[row]; });
}

void ScanlineFill::placeRing(const Ring &ring, int orientation)
{
    forEachCrossing(ring,
                    [this, orientation](std::size_t row, double x, int winding) {
                        crossings_[--rowStart_[row]] = {x, winding * orientation};
                    });
}

void ScanlineFill::fill(const Polygon &polygon, CellBits &bits)
{
    // Counting sort by row: count, sum up, place from the end; then sort the few crossings of each row by x.
    limitRows(polygon);
    rowStart_.assign(static_cast<std::size_t>(end_ - begin_) + 1, 0);
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
    for (std::int64_t row = begin_; row < end_; ++row)
    {
        const auto begin = crossings_.begin() + rowStart_[static_cast<std::size_t>(row - begin_)];
        const auto end = crossings_.begin() + rowStart_[static_cast<std::size_t>(row - begin_) + 1];
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
