#include "Surroundings.h"

#include "seahex/geometry/AreaTouch.h"
#include "seahex/geometry/Box.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace seahex
{
namespace
{

namespace bgi = boost::geometry::index;

constexpr double UNKNOWN_DEPTH_M = -1.0;

using Corner = boost::geometry::model::d2::point_xy<double>;
using IndexBox = boost::geometry::model::box<Corner>;
using Entry = std::pair<IndexBox, std::size_t>;
using Tree = bgi::rtree<Entry, bgi::quadratic<16>>;

/// Grows with what it is shown.
class Extent
{
public:
    template <class Points>
    void add(const Points &points)
    {
        for (const Point &p : points)
        {
            box_.min = any_ ? Point(box_.min.cwiseMin(p)) : p;
            box_.max = any_ ? Point(box_.max.cwiseMax(p)) : p;
            any_ = true;
        }
    }

    bool isEmpty() const { return !any_; }
    IndexBox box() const { return IndexBox(Corner(box_.min.x(), box_.min.y()), Corner(box_.max.x(), box_.max.y())); }

private:
    Box box_;
    bool any_ = false;
};

/// An area of one depth under dangers.
class Bed
{
public:
    Bed(const Polygon &area, bool surveyed, double leastDepthM)
        : area_(&area), surveyed_(surveyed), leastDepthM_(leastDepthM)
    {
    }

    const Polygon &area() const { return *area_; }
    bool isSurveyed() const { return surveyed_; }
    double leastDepthM() const { return leastDepthM_; }

    /// True if they share any point. Most areas are never asked, and those that are, often.
    bool touches(const Shape &shape)
    {
        if (!touch_)
            touch_.emplace(*area_);
        return touch_->touches(shape);
    }

private:
    const Polygon *area_;
    bool surveyed_;
    double leastDepthM_;
    std::optional<AreaTouch> touch_;
};

std::vector<Bed> bedsOf(const CellContents &cell)
{
    std::vector<Bed> beds;
    for (const DraftHazard &hazard : cell.hazards)
    {
        const bool surveyed = hazard.object.rule == HazardRule::DepthArea;
        if (!surveyed && hazard.object.objectClass != "UNSARE")
            continue;
        const double depthM = hazard.object.value("DRVAL1").value_or(UNKNOWN_DEPTH_M);
        for (const Polygon &area : hazard.lonLat.areas)
            beds.emplace_back(area, surveyed, depthM);
    }
    return beds;
}

Tree treeOf(const std::vector<Bed> &beds)
{
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < beds.size(); ++i)
    {
        Extent extent;
        extent.add(beds[i].area().outer());
        if (!extent.isEmpty())
            entries.emplace_back(extent.box(), i);
    }
    return Tree(entries);
}

std::optional<double> leastDepthUnder(const Shape &danger, std::vector<Bed> &beds, const Tree &tree)
{
    Extent extent;
    extent.add(danger.points);
    for (const LineString &line : danger.lines)
        extent.add(line);
    for (const Polygon &area : danger.areas)
        extent.add(area.outer());
    if (extent.isEmpty())
        return std::nullopt;

    std::vector<Entry> candidates;
    tree.query(bgi::intersects(extent.box()), std::back_inserter(candidates));
    std::optional<double> least;
    for (const Entry &candidate : candidates)
    {
        Bed &bed = beds[candidate.second];
        if (!bed.touches(danger))
            continue;
        if (!bed.isSurveyed())
            return std::nullopt;
        least = std::min(least.value_or(bed.leastDepthM()), bed.leastDepthM());
    }
    return least;
}

}  // namespace

void fillSurroundingDepths(CellContents &cell)
{
    std::vector<Bed> beds = bedsOf(cell);
    const Tree tree = treeOf(beds);
    for (DraftHazard &hazard : cell.hazards)
        if (hazard.object.rule == HazardRule::Danger)
            hazard.object.surroundingDepthM = leastDepthUnder(hazard.lonLat, beds, tree);
}

}  // namespace seahex
