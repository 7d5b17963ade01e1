#include "seahex/world/HazardIndex.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
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

double pointToSegment(const Point &p, const Segment &s)
{
    const Point d = s.second - s.first;
    const double squared = d.squaredNorm();
    const double t = squared > 0.0 ? std::clamp((p - s.first).dot(d) / squared, 0.0, 1.0) : 0.0;
    return (p - s.first - t * d).norm();
}

double segmentToSegment(const Segment &a, const Segment &b)
{
    if (bg::intersects(a, b))
        return 0.0;
    return std::min({pointToSegment(a.first, b), pointToSegment(a.second, b), pointToSegment(b.first, a),
                     pointToSegment(b.second, a)});
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
        Near best{nullptr, std::numeric_limits<double>::infinity()};
        if (const Hazard *inside = areaAround(segment.first))
            return {inside, 0.0};
        // Boxes come in the order of their distance, which is not more than that of what they hold.
        for (auto it = pieceTree_.qbegin(bgi::nearest(segment, pieceTree_.size())); it != pieceTree_.qend(); ++it)
        {
            if (bg::distance(segment, it->first) > best.distance)
                break;
            const Piece &piece = pieces_[it->second];
            const double distance = segmentToSegment(segment, piece.segment);
            if (distance < best.distance)
                best = {piece.hazard, distance};
            if (distance == 0.0)
                break;
        }
        return best;
    }

    std::vector<Near> within(const Segment &segment, double distance) const
    {
        std::map<const Hazard *, double> found;
        BoundingBox box = bg::return_envelope<BoundingBox>(segment);
        const Point reach(distance, distance);
        box = BoundingBox(box.min_corner() - reach, box.max_corner() + reach);
        for (auto it = pieceTree_.qbegin(bgi::intersects(box)); it != pieceTree_.qend(); ++it)
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
        pieceBoxes_.emplace_back(bg::return_envelope<BoundingBox>(pieces_.back().segment), pieces_.size() - 1);
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
