#include "LayerReader.h"

#include "S57Classes.h"

#include "seahex/chart/ChartError.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace seahex
{
namespace
{

// S-57's codes.
constexpr int NO_GEOMETRY = 255;
constexpr int COVERAGE_AVAILABLE = 1;
constexpr int METRES = 1;

/// An edge this long, straight in a projected frame, lies within some centimetres of the straight longitude-latitude
/// edge between its ends (length squared, times the tangent of the latitude, over eight earth radii).
constexpr double LONGEST_PROJECTED_EDGE_M = 500.0;

bool canBlock(HazardRule rule)
{
    switch (rule)
    {
        case HazardRule::Always:
        case HazardRule::DepthArea:
        case HazardRule::Sounding:
        case HazardRule::Danger:
        case HazardRule::MarineFarm:
        case HazardRule::Mooring:
        case HazardRule::Cable:  // under water
        case HazardRule::Pipeline:
        case HazardRule::ChartGap:
        case HazardRule::Caution:  // where WATLEV says that it shows
            return true;
        case HazardRule::Overhead:
        case HazardRule::Regulation:
        case HazardRule::Quality:
        case HazardRule::Ignored:
            break;
    }
    return false;
}

/// The driver goes on with what it has of a geometry, and says so.
bool tellsOfBrokenGeometry(const std::string &message)
{
    return message.find("missing geometry") != std::string::npos || message.find("corrupt") != std::string::npos ||
           message.find("incomplete") != std::string::npos || message.find("empty geometry") != std::string::npos ||
           message.find("spatial record") != std::string::npos;
}

double radiusOf(const Shape &shape, const HazardClass &row)
{
    double radiusM = 0.0;
    if (!shape.points.empty())
        radiusM = std::max(radiusM, row.pointRadiusM);
    if (!shape.lines.empty())
        radiusM = std::max(radiusM, row.lineRadiusM);
    if (!shape.areas.empty())
        radiusM = std::max(radiusM, row.areaRadiusM);
    return radiusM;
}

bool isWgs84Degrees(const OGRSpatialReference &frame, const OGRSpatialReference &wgs84)
{
    const char *const ignoreAxes[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
    return frame.IsGeographic() && frame.GetDataAxisToSRSAxisMapping() == wgs84.GetDataAxisToSRSAxisMapping() &&
           frame.IsSame(&wgs84, ignoreAxes);
}

}  // namespace

LayerReader::LayerReader(OGRLayer &layer, std::string objectClass, DriverMessages &messages, CellContents &cell,
                         InDegrees)
    : layer_(layer), objectClass_(std::move(objectClass)), row_(findHazardClass(objectClass_)), messages_(messages),
      cell_(cell), fields_(*layer.GetLayerDefn())
{
}

LayerReader::LayerReader(OGRLayer &layer, std::string objectClass, DriverMessages &messages, CellContents &cell)
    : LayerReader(layer, std::move(objectClass), messages, cell, InDegrees{})
{
    const OGRSpatialReference *frame = layer_.GetSpatialRef();
    if (frame == nullptr)
    {
        if (layer_.GetGeomType() != wkbNone)
            cell_.warn("layer " + std::string(layer_.GetName()) + " of " + cell_.report.name +
                       " names no coordinate system: its coordinates are taken as WGS-84 degrees");
        return;
    }
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (isWgs84Degrees(*frame, wgs84))
        return;
    toDegrees_.reset(OGRCreateCoordinateTransformation(frame, &wgs84));
    if (!toDegrees_)
        throw ChartUnsupported("layer " + std::string(layer_.GetName()) + " of " + cell_.report.name +
                               " is in a coordinate system that can't be turned into WGS-84: " + messages_.last());
    if (frame->IsProjected())
        longestEdge_ = LONGEST_PROJECTED_EDGE_M / frame->GetLinearUnits();
}

void LayerReader::read()
{
    // Nothing of the feature itself is asked for, so the driver need not make it.
    if (!isJudged() && !isContour() && objectClass_ != "M_COVR" && objectClass_ != "M_UNIT" &&
        layer_.TestCapability(OLCFastFeatureCount))
    {
        const auto count = static_cast<std::size_t>(std::max<GIntBig>(layer_.GetFeatureCount(), 0));
        cell_.report.featuresRead += count;
        return cell_.skip(whyNotJudged(), objectClass_, count);
    }
    layer_.ResetReading();
    for (;;)
    {
        messages_.listenAnew();
        const OGRFeatureUniquePtr feature(layer_.GetNextFeature());
        if (!feature)
            break;
        ++cell_.report.featuresRead;
        readFeature(*feature, tellsOfBrokenGeometry(messages_.recent()));
    }
}

bool LayerReader::isContour() const
{
    return objectClass_ == "DEPCNT";
}

bool LayerReader::isJudged() const
{
    return row_ != nullptr && row_->rule != HazardRule::Ignored;
}

std::string LayerReader::whyNotJudged() const
{
    return row_ == nullptr ? seahex::whyNotJudged(objectClass_) : "ignored by rule";
}

void LayerReader::readFeature(const OGRFeature &feature, bool isBroken)
{
    if (objectClass_ == "M_UNIT")
        readUnits(feature);
    const bool isCoverage = objectClass_ == "M_COVR";
    if (!isJudged() && !isCoverage && !isContour())
        return cell_.skip(whyNotJudged(), objectClass_);

    const OGRGeometry *geometry = feature.GetGeometryRef();
    const bool empty = geometry == nullptr || geometry->IsEmpty();
    const bool matters = isCoverage || canBlock(row_->rule);
    if (matters && isBroken)
        throw ChartDamaged(who(feature) + " has a broken geometry: " + messages_.recent());
    if (matters && empty && isExpectedOnChart(feature))
        throw ChartDamaged(who(feature) + " has no geometry");
    if (empty)
        return cell_.skip("no geometry", objectClass_);

    if (isCoverage)
        readCoverage(feature);
    else if (isContour())
        readContour(feature);
    else if (row_->rule == HazardRule::Sounding)
        readSounding(feature);
    else
        readHazard(feature);
}

void LayerReader::readCoverage(const OGRFeature &feature)
{
    std::vector<Polygon> areas = shapeOf(feature).areas;
    if (fields_.code(feature, "CATCOV") != COVERAGE_AVAILABLE)
    {
        std::move(areas.begin(), areas.end(), std::back_inserter(cell_.noData));
        return cell_.skip("no data within it (CATCOV is not 1)", objectClass_);
    }
    if (areas.empty())
        return cell_.skip("coverage without an area", objectClass_);
    std::move(areas.begin(), areas.end(), std::back_inserter(cell_.coverage));
    ++cell_.report.featuresUsed;
}

/// What there is of a broken line still has its depth.
void LayerReader::readContour(const OGRFeature &feature)
{
    const std::vector<double> depth = fields_.numbers(feature, "VALDCO");
    if (depth.size() != 1 || !std::isfinite(depth.front()))
        return cell_.skip("contour without a depth (VALDCO)", objectClass_);
    cell_.contours.push_back({depth.front(), shapeOf(feature)});
    ++cell_.report.featuresUsed;
}

void LayerReader::readUnits(const OGRFeature &feature)
{
    const std::optional<int> unit = fields_.code(feature, "DUNITS");
    if (unit && *unit != METRES)
        throw ChartUnsupported(who(feature) + " gives depths in another unit than metres: DUNITS is " +
                               std::to_string(*unit));
}

void LayerReader::readSounding(const OGRFeature &feature)
{
    const HazardObject whole = objectOf(feature);
    const bool hasField = whole.value("DEPTH").has_value();
    for (const PointWithHeight &point : pointsOf(*geometryInDegrees(feature), nameOf(feature)))
    {
        DraftHazard sounding{whole, {}};
        sounding.lonLat.points.push_back(point.position);
        sounding.object.radiusM = row_->pointRadiusM;
        if (!hasField && point.hasHeight && std::isfinite(point.height))
            sounding.object.attributes.push_back({"DEPTH", {point.height}});
        cell_.hazards.push_back(std::move(sounding));
    }
    ++cell_.report.featuresUsed;
}

void LayerReader::readHazard(const OGRFeature &feature)
{
    DraftHazard hazard{objectOf(feature), shapeOf(feature)};
    hazard.object.radiusM = radiusOf(hazard.lonLat, *row_);
    cell_.hazards.push_back(std::move(hazard));
    ++cell_.report.featuresUsed;
}

Shape LayerReader::shapeOf(const OGRFeature &feature) const
{
    return toShape(*geometryInDegrees(feature), nameOf(feature));
}

/// The feature's own geometry where it is in degrees already.
std::shared_ptr<const OGRGeometry> LayerReader::geometryInDegrees(const OGRFeature &feature) const
{
    if (!toDegrees_)
        return std::shared_ptr<const OGRGeometry>(std::shared_ptr<void>(), feature.GetGeometryRef());
    std::unique_ptr<OGRGeometry> geometry(feature.GetGeometryRef()->clone());
    if (longestEdge_ > 0.0)
    {
        if (geometry->hasCurveGeometry())
            geometry.reset(geometry->getLinearGeometry(ARC_STEP_DEG));
        geometry->segmentize(longestEdge_);
    }
    if (geometry->transform(toDegrees_.get()) != OGRERR_NONE)
        throw ChartDamaged(who(feature) + " has coordinates that can't be turned into WGS-84: " + messages_.last());
    return geometry;
}

/// S-57 marks objects that are meant to have no position; elsewhere every object is meant to have one.
bool LayerReader::isExpectedOnChart(const OGRFeature &feature) const
{
    return fields_.code(feature, "PRIM").value_or(0) != NO_GEOMETRY;
}

HazardObject LayerReader::objectOf(const OGRFeature &feature) const
{
    HazardObject object;
    object.objectClass = objectClass_;
    object.rule = row_->rule;
    object.cell = cell_.report.name;
    object.featureId = fields_.id(feature);
    object.name = fields_.name(feature);
    object.attributes = fields_.attributes(feature);
    return object;
}

Who LayerReader::nameOf(const OGRFeature &feature) const
{
    return [this, &feature]
    {
        return who(feature);
    };
}

std::string LayerReader::who(const OGRFeature &feature) const
{
    return objectClass_ + " " + fields_.id(feature) + " of '" + cell_.report.source + "'";
}

}  // namespace seahex
