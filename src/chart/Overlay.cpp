#include "Overlay.h"

#include "OgrShape.h"

#include <cmath>
#include <memory>

namespace seahex
{
namespace
{

/// The union of the parts, made valid first where that is needed.
std::unique_ptr<OGRGeometry> united(const std::vector<Polygon> &areas)
{
    const std::unique_ptr<OGRMultiPolygon> parts = toOgr(areas);
    std::unique_ptr<OGRGeometry> whole(parts->UnionCascaded());
    if (whole)
        return whole;
    OGRGeometryCollection valid;
    for (const OGRPolygon *part : *parts)
        if (OGRGeometry *made = part->MakeValid())
            valid.addGeometryDirectly(made);
    const std::vector<Polygon> mended = toShape(valid, [] { return "an area made valid"; }).areas;
    return std::unique_ptr<OGRGeometry>(toOgr(mended)->UnionCascaded());
}

}  // namespace

std::vector<Polygon> unite(const std::vector<Polygon> &areas)
{
    if (areas.size() < 2)
        return areas;
    const std::unique_ptr<OGRGeometry> whole = united(areas);
    return whole ? toShape(*whole, [] { return "the union of areas"; }).areas : std::vector<Polygon>();
}

bool subtract(const std::vector<Polygon> &areas, const std::vector<Polygon> &others, double widthDeg,
              std::vector<Polygon> &rest)
{
    const std::unique_ptr<OGRGeometry> whole = united(areas);
    const std::unique_ptr<OGRGeometry> covered = united(others);
    if (!whole || !covered)
        return false;
    const std::unique_ptr<OGRGeometry> difference(whole->Difference(covered.get()));
    if (!difference)
        return false;

    rest.clear();
    for (Polygon &part : toShape(*difference, [] { return "the difference of areas"; }).areas)
    {
        const std::unique_ptr<OGRGeometry> core(toOgr(std::vector<Polygon>{part})->Buffer(-0.5 * widthDeg));
        if (!core || !core->IsEmpty())
            rest.push_back(std::move(part));
    }
    return true;
}

bool overlap(const std::vector<Polygon> &a, const std::vector<Polygon> &b)
{
    const std::unique_ptr<OGRGeometry> common(toOgr(a)->Intersection(toOgr(b).get()));
    return common && areaDeg2(toShape(*common, [] { return "the intersection of coverages"; }).areas) > 0.0;
}

bool isSimple(const std::vector<Polygon> &areas)
{
    const std::unique_ptr<OGRMultiPolygon> parts = toOgr(areas);
    for (const OGRPolygon *part : *parts)
        if (!part->IsValid())
            return false;
    return true;
}

double areaDeg2(const std::vector<Polygon> &areas)
{
    double sum = 0.0;
    for (const Polygon &area : areas)
    {
        sum += std::abs(signedArea(area.outer()));
        for (const Ring &hole : area.inners())
            sum -= std::abs(signedArea(hole));
    }
    return sum;
}

}  // namespace seahex
