#include "seahex/world/HazardIndex.h"

#include "seahex/geometry/SegmentDistance.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

namespace seahex
{
namespace
{

using Segment = bg::model::segment<Point>;
using BoundingBox = bg::model::box<Point>;

struct Piece
{
    Segment segment;  // a point is a segment of no length
    const Hazard *hazard;
};

struct Area
{
    const Polygon *polygon;
    const Hazard *hazard;
};

double side(const Segment &s, const Point &p)
{
    const Point d = s.second - s.first;
    const Point e = p - s.first;
    return d.x() * e.y() - d.y() * e.x();
}

bool strictlyApart(double a, double b)
{
    return (a > 0.0 && b > 0.0) || (a < 0.0 && b < 0.0);
}

/// Exact up to rounding. Segments that merely touch may count as crossing or as 1e-16 of their size apart.
double segmentToSegment(const Segment &a, const Segment &b)
{
    const double ends =
        std::min({distanceToSegment(a.first, b.first, b.second), distanceToSegment(a.second, b.first, b.second),
                  distanceToSegment(b.first, a.first, a.second), distanceToSegment(b.second, a.first, a.second)});
    if (ends == 0.0 || strictlyApart(side(a, b.first), side(a, b.second)) ||
        strictlyApart(side(b, a.first), side(b, a.second)))
        return ends;
    // Neither has both ends on one side of the other: they cross, or lie on one line, where the ends tell.
    const bool collinear = side(a, b.first) == 0.0 && side(a, b.second) == 0.0;
    return collinear ? ends : 0.0;
}

BoundingBox boxAround(const Segment &segment, double reach)
{
    const Point d(reach, reach);
    return BoundingBox(segment.first.cwiseMin(segment.second) - d, segment.first.cwiseMax(segment.second) + d);
}

}  // namespace

class HazardIndex::Trees
{
public:
    void add(const Hazard &hazard)
    {
        for (const Point &p : hazard.shape.points)
            addPiece(p, p, hazard);
        forEachSegment(hazard.shape, [&](const Point &a, const Point &b) { addPiece(a, b, hazard); });
        for (const Polygon &polygon : hazard.shape.areas)
        {
            areas_.push_back({&polygon, &hazard});
            areaBoxes_.emplace_back(bg::return_envelope<BoundingBox>(polygon), areas_.size() - 1);
        }
    }

    void pack()
    {
        pieceTree_ = Tree(pieceBoxes_);
        areaTree_ = Tree(areaBoxes_);
        pieceBoxes_ = {};
        areaBoxes_ = {};
    }

    Near nearest(const Segment &segment) const
    {
        if (const Hazard *inside = areaAround(segment.first))
            return {inside, 0.0};
        // The pieces with the nearest boxes bound the distance; whatever is nearer has its box within that bound.
        Near best{nullptr, std::numeric_limits<double>::infinity()};
        const auto offer = [&](const Entry &entry)
        {
            const Piece &piece = pieces_[entry.second];
            const double distance = segmentToSegment(segment, piece.segment);
            if (distance < best.distance)
                best = {piece.hazard, distance};
        };
        std::vector<Entry> seeds;
        pieceTree_.query(bgi::nearest(segment, 4), std::back_inserter(seeds));
        std::for_each(seeds.begin(), seeds.end(), offer);
        if (best.hazard != nullptr && best.distance > 0.0)
            pieceTree_.query(bgi::intersects(boxAround(segment, best.distance)),
                             boost::make_function_output_iterator(offer));
        return best;
    }

    std::vector<Near> within(const Segment &segment, double distance) const
    {
        std::map<const Hazard *, double> found;
        for (auto it = pieceTree_.qbegin(bgi::intersects(boxAround(segment, distance))); it != pieceTree_.qend(); ++it)
        {
            const Piece &piece = pieces_[it->second];
            const double d = segmentToSegment(segment, piece.segment);
            if (d > distance)
                continue;
            const auto [known, isNew] = found.emplace(piece.hazard, d);
            known->second = std::min(known->second, d);
        }
        for (auto it = areaTree_.qbegin(bgi::intersects(segment.first)); it != areaTree_.qend(); ++it)
            if (bg::covered_by(segment.first, *areas_[it->second].polygon))
                found[areas_[it->second].hazard] = 0.0;
        std::vector<Near> result;
        result.reserve(found.size());
        for (const auto &[hazard, d] : found)
            result.push_back({hazard, d});
        return result;
    }

private:
    using Entry = std::pair<BoundingBox, std::size_t>;
    using Tree = bgi::rtree<Entry, bgi::rstar<16>>;

    void addPiece(const Point &a, const Point &b, const Hazard &hazard)
    {
        pieces_.push_back({Segment(a, b), &hazard});
        pieceBoxes_.emplace_back(boxAround(pieces_.back().segment, 0.0), pieces_.size() - 1);
    }

    const Hazard *areaAround(const Point &p) const
    {
        for (auto it = areaTree_.qbegin(bgi::intersects(p)); it != areaTree_.qend(); ++it)
            if (bg::covered_by(p, *areas_[it->second].polygon))
                return areas_[it->second].hazard;
        return nullptr;
    }

    std::vector<Piece> pieces_;
    std::vector<Area> areas_;
    std::vector<Entry> pieceBoxes_;
    std::vector<Entry> areaBoxes_;
    Tree pieceTree_;
    Tree areaTree_;
};

HazardIndex::HazardIndex(const std::vector<Hazard> &hazards, const std::function<bool(const Hazard &)> &select)
{
    auto trees = std::make_unique<Trees>();
    for (const Hazard &hazard : hazards)
        if (select(hazard))
            trees->add(hazard);
    trees->pack();
    trees_ = std::move(trees);
}

HazardIndex::~HazardIndex() = default;
HazardIndex::HazardIndex(HazardIndex &&) noexcept = default;
HazardIndex &HazardIndex::operator=(HazardIndex &&) noexcept = default;

HazardIndex::Near HazardIndex::nearest(const Point &a, const Point &b) const
{
    return trees_->nearest(Segment(a, b));
}

std::vector<HazardIndex::Near> HazardIndex::within(const Point &a, const Point &b, double distance) const
{
    return trees_->within(Segment(a, b), distance);
}

}  // namespace seahex
