#include "Surroundings.h"

#include "OgrShape.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <ogr_api.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace seahex
{
namespace
{

namespace bgi = boost::geometry::index;

constexpr double UNKNOWN_DEPTH_M = -1.0;

using Corner = boost::geometry::model::d2::point_xy<double>;
using Box = boost::geometry::model::box<Corner>;
using Entry = std::pair<Box, std::size_t>;
using Tree = bgi::rtree<Entry, bgi::quadratic<16>>;

Box boxOf(const OGRGeometry &geometry)
{
    OGREnvelope box;
    geometry.getEnvelope(&box);
    return Box(Corner(box.MinX, box.MinY), Corner(box.MaxX, box.MaxY));
}

/// An area of one depth under dangers.
class Bed
{
public:
    Bed(const Polygon &area, bool surveyed, double leastDepthM)
        : area_(toOgr(std::vector<Polygon>{area})), surveyed_(surveyed), leastDepthM_(leastDepthM)
    {
    }

    const OGRGeometry &area() const { return *area_; }
    bool isSurveyed() const { return surveyed_; }
    double leastDepthM() const { return leastDepthM_; }

    /// True if they share any point. Large areas are asked often, so the first question prepares the answer to others.
    bool touches(const OGRGeometry &geometry) const
    {
        if (!prepared_ && OGRHasPreparedGeometrySupport())
            prepared_.reset(OGRCreatePreparedGeometry(OGRGeometry::ToHandle(area_.get())));
        if (!prepared_)
            return area_->Intersects(&geometry) != FALSE;
        // The C interface takes no const pointers, but does not change what they point to.
        return OGRPreparedGeometryIntersects(prepared_.get(),
                                             OGRGeometry::ToHandle(const_cast<OGRGeometry *>(&geometry))) != FALSE;
    }

private:
    std::unique_ptr<OGRMultiPolygon> area_;
    bool surveyed_;
    double leastDepthM_;
    mutable OGRPreparedGeometryUniquePtr prepared_;
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
        entries.emplace_back(boxOf(beds[i].area()), i);
    return Tree(entries);
}

std::optional<double> leastDepthUnder(const OGRGeometry &danger, const std::vector<Bed> &beds, const Tree &tree)
{
    std::vector<Entry> candidates;
    tree.query(bgi::intersects(boxOf(danger)), std::back_inserter(candidates));
    std::optional<double> least;
    for (const Entry &candidate : candidates)
    {
        const Bed &bed = beds[candidate.second];
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
    const std::vector<Bed> beds = bedsOf(cell);
    const Tree tree = treeOf(beds);
    for (DraftHazard &hazard : cell.hazards)
        if (hazard.object.rule == HazardRule::Danger)
            hazard.object.surroundingDepthM = leastDepthUnder(*toOgr(hazard.lonLat), beds, tree);
}

}  // namespace seahex
