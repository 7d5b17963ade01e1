#include "seahex/world/OccupancyBuilder.h"

#include "seahex/geometry/SegmentSpans.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace seahex
{
namespace
{

/// A coordinate that is not a number would compare false with everything and block nothing, silently.
void requireFinite(const Shape &shape)
{
    bool finite = true;
    const auto look = [&finite](const auto &points)
    {
        for (const Point &p : points)
            finite = finite && p.allFinite();
    };
    look(shape.points);
    for (const LineString &line : shape.lines)
        look(line);
    for (const Polygon &area : shape.areas)
    {
        look(area.outer());
        for (const Ring &hole : area.inners())
            look(hole);
    }
    if (!finite)
        throw std::domain_error("a shape to be blocked has a coordinate that is not a number");
}

}  // namespace

template <class KnownLattice>
OccupancyBuilder<KnownLattice>::OccupancyBuilder(const KnownLattice &lattice)
    : lattice_(lattice), cells_(lattice), bits_(CellLayout(lattice.columns(), lattice.rows())), fill_(lattice)
{
    bits_.setOutside();
}

template <class KnownLattice>
OccupancyBuilder<KnownLattice>::OccupancyBuilder(const LatticeOccupancy<KnownLattice> &occupancy)
    : lattice_(occupancy.lattice()), cells_(lattice_), bits_(occupancy.layout()), fill_(lattice_)
{
    bits_.words().assign(occupancy.words().begin(), occupancy.words().end());
}

template <class KnownLattice>
void OccupancyBuilder<KnownLattice>::blockNear(const Point &a, const Point &b, double radius)
{
    const SegmentSpans spans(cells_, a, b, radius);
    const std::int64_t last = std::min(spans.lastRow(), lattice_.rows() - 1);
    for (std::int64_t row = std::max<std::int64_t>(spans.firstRow(), 0); row <= last; ++row)
    {
        const RowSpan span = spans.span(row);
        bits_.setSpan(row, span.firstColumn, span.lastColumn);
    }
}

template <class KnownLattice>
void OccupancyBuilder<KnownLattice>::block(const Shape &shape, double radius)
{
    requireFinite(shape);
    for (const Point &point : shape.points)
        blockNear(point, point, radius);
    // a line or ring of a single point has no segment that would stand for it
    const auto blockLonePoint = [this, radius](const auto &line)
    {
        if (line.size() == 1)
            blockNear(line.front(), line.front(), radius);
    };
    for (const LineString &line : shape.lines)
        blockLonePoint(line);
    forEachSegment(shape, [this, radius](const Point &a, const Point &b) { blockNear(a, b, radius); });
    for (const Polygon &area : shape.areas)
    {
        fill_.fill(area, bits_);
        blockLonePoint(area.outer());
        for (const Ring &hole : area.inners())
            blockLonePoint(hole);
    }
}

template <class KnownLattice>
void OccupancyBuilder<KnownLattice>::blockOutside(const std::vector<Polygon> &areas, double radius)
{
    CellBits inside(bits_.layout());
    requireFinite({{}, {}, areas});
    for (const Polygon &area : areas)
        fill_.fill(area, inside);
    for (std::size_t i = 0; i < bits_.words().size(); ++i)
        bits_.words()[i] |= ~inside.words()[i];
    for (const Polygon &area : areas)
    {
        Shape edge;
        edge.lines.emplace_back(area.outer().begin(), area.outer().end());
        for (const Ring &hole : area.inners())
            edge.lines.emplace_back(hole.begin(), hole.end());
        block(edge, radius);
    }
}

template <class KnownLattice>
std::shared_ptr<const LatticeOccupancy<KnownLattice>> OccupancyBuilder<KnownLattice>::build() const &
{
    return std::make_shared<const LatticeOccupancy<KnownLattice>>(lattice_, bits_.layout(), bits_.words());
}

template <class KnownLattice>
std::shared_ptr<const LatticeOccupancy<KnownLattice>> OccupancyBuilder<KnownLattice>::build() &&
{
    return std::make_shared<const LatticeOccupancy<KnownLattice>>(lattice_, bits_.layout(), std::move(bits_.words()));
}

template class OccupancyBuilder<HexLattice>;
template class OccupancyBuilder<SquareLattice>;

}  // namespace seahex
