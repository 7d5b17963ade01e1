#include "seahex/io/GeoJson.h"

#include "PartFile.h"
#include "chart/GdalDataset.h"
#include "seahex/geometry/Point3.h"

#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace seahex
{

namespace
{

[[noreturn]] void failBecause(const std::string &reason)
{
    throw PartFile::Failure(reason);
}

/// Longitude, latitude, height; the last is 0 at the surface.
using Pieces = std::vector<std::vector<Point3>>;

/// Adds a leg that touches the antimeridian at most with its ends; its longitudes are brought to its own side.
void addUncut(Pieces &pieces, const Point3 &from, const Point3 &to)
{
    const Point3 turn(360.0 * std::floor((0.5 * (from.x() + to.x()) + 180.0) / 360.0), 0.0, 0.0);
    const bool joins = !pieces.empty() && (pieces.back().back() - (from - turn)).norm() < 1e-9;  // but for rounding
    if (!joins)
        pieces.push_back({from - turn});
    pieces.back().push_back(to - turn);
}

void addLeg(Pieces &pieces, const Point3 &from, Point3 to)
{
    to.x() += 360.0 * std::round((from.x() - to.x()) / 360.0);
    const double border = to.x() > from.x() ? 180.0 : -180.0;
    if ((to.x() - border) * (from.x() - border) >= 0.0)
        return addUncut(pieces, from, to);
    const double t = (border - from.x()) / (to.x() - from.x());
    Point3 cut = from + t * (to - from);
    cut.x() = border;
    addUncut(pieces, from, cut);
    addUncut(pieces, cut, to);
}

Point3 lonLatHeight(const GeoRoute &route, std::size_t i)
{
    const GeoPoint p = writtenPosition(route.waypoints[i]);
    return {p.longitudeDeg(), p.latitudeDeg(), route.depthsM.empty() ? 0.0 : -route.depthsM[i]};
}

/// The route as pieces that don't cross the antimeridian. (OGR's own cutting would dissolve a line that crosses
/// itself.)
Pieces cutAtAntimeridian(const GeoRoute &route)
{
    Pieces pieces;
    for (std::size_t i = 1; i < route.waypoints.size(); ++i)
        addLeg(pieces, lonLatHeight(route, i - 1), lonLatHeight(route, i));
    return pieces;
}

std::unique_ptr<OGRGeometry> lineOf(const GeoRoute &route)
{
    auto lines = std::make_unique<OGRMultiLineString>();
    for (const std::vector<Point3> &piece : cutAtAntimeridian(route))
    {
        auto line = std::make_unique<OGRLineString>();
        for (const Point3 &p : piece)
            if (route.depthsM.empty())
                line->addPoint(p.x(), p.y());
            else
                line->addPoint(p.x(), p.y(), p.z());
        lines->addGeometryDirectly(line.release());
    }
    if (lines->getNumGeometries() > 1)
        return lines;
    return std::unique_ptr<OGRGeometry>(lines->getGeometryRef(0)->clone());
}

/// The closed cell, with longitudes that may run on past 180; the driver cuts and rounds them.
std::unique_ptr<OGRGeometry> polygonOf(const Lattice &lattice, OffsetCoord cell, const Projection &projection)
{
    auto ring = std::make_unique<OGRLinearRing>();
    for (const Point &corner : lattice.corners(cell))
    {
        const GeoPoint position = projection.inverse(corner);
        ring->addPoint(position.longitudeDeg(), position.latitudeDeg());
    }
    ring->closeRings();
    auto polygon = std::make_unique<OGRPolygon>();
    polygon->addRingDirectly(ring.release());
    return polygon;
}

/// Three decimals are plenty for metres and for degrees of a course.
double rounded(double value)
{
    return std::round(value * 1000.0) / 1000.0;
}

/// One file through GDAL's driver.
class FeatureWriter
{
public:
    FeatureWriter(const PartFile &file, const DriverMessages &messages) : messages_(messages)
    {
        static std::once_flag registered;
        std::call_once(registered, [] { GDALAllRegister(); });
        GDALDriver *driver = GetGDALDriverManager()->GetDriverByName("GeoJSON");
        if (driver == nullptr)
            failBecause("this GDAL has no GeoJSON driver");
        dataset_.reset(driver->Create(file.name().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        if (!dataset_)
            fail();

        OGRSpatialReference wgs84;
        wgs84.SetWellKnownGeogCS("WGS84");
        wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);  // longitude first
        std::string rfc = "RFC7946=YES";
        std::string decimals = "COORDINATE_PRECISION=" + std::to_string(positionDecimals);
        char *options[] = {rfc.data(), decimals.data(), nullptr};
        layer_ = dataset_->CreateLayer("seahex", &wgs84, wkbUnknown, options);
        if (layer_ == nullptr)
            fail();
    }

    void addField(const std::string &name, OGRFieldType type)
    {
        if (layer_->GetLayerDefn()->GetFieldIndex(name.c_str()) >= 0)
            failBecause("the property \"" + name + "\" would be there twice");
        OGRFieldDefn field(name.c_str(), type);
        if (layer_->CreateField(&field) != OGRERR_NONE)
            fail();
    }

    std::unique_ptr<OGRFeature> feature(const char *kind) const
    {
        auto feature = std::make_unique<OGRFeature>(layer_->GetLayerDefn());
        feature->SetField("kind", kind);
        return feature;
    }

    void write(OGRFeature &feature, std::unique_ptr<OGRGeometry> geometry)
    {
        feature.SetGeometryDirectly(geometry.release());
        if (layer_->CreateFeature(&feature) != OGRERR_NONE)
            fail();
    }

    void close() { dataset_.reset(); }

private:
    [[noreturn]] void fail() const
    {
        failBecause(messages_.last().empty() ? "the GeoJSON driver failed" : messages_.last());
    }

    const DriverMessages &messages_;
    GdalDataset dataset_;
    OGRLayer *layer_ = nullptr;
};

void addFields(FeatureWriter &writer, const RouteFileContent &content)
{
    writer.addField("kind", OFTString);
    writer.addField("index", OFTInteger64);
    writer.addField("course_deg", OFTReal);
    writer.addField("leg_length_m", OFTReal);
    if (content.route != nullptr && !content.route->depthsM.empty())
        writer.addField("depth_m", OFTReal);
    for (const char *coordinate : {"q", "r", "s", "column", "row"})
        writer.addField(coordinate, OFTInteger64);
    for (const auto &[name, value] : content.numbers)
        writer.addField(name, OFTReal);
    for (const auto &[name, value] : content.texts)
        writer.addField(name, OFTString);
}

void writeRoute(FeatureWriter &writer, const RouteFileContent &content)
{
    const auto feature = writer.feature("route");
    for (const auto &[name, value] : content.numbers)
        if (std::isfinite(value))
            feature->SetField(name.c_str(), value);
        else
            feature->SetFieldNull(feature->GetFieldIndex(name.c_str()));
    for (const auto &[name, value] : content.texts)
        feature->SetField(name.c_str(), value.c_str());
    writer.write(*feature, lineOf(*content.route));
}

void writeWaypoints(FeatureWriter &writer, const GeoRoute &route)
{
    for (std::size_t i = 0; i < route.waypoints.size(); ++i)
    {
        const auto feature = writer.feature("waypoint");
        feature->SetField("index", static_cast<GIntBig>(i) + 1);
        const GeoPoint here = writtenPosition(route.waypoints[i]);
        if (i + 1 < route.waypoints.size())
        {
            const RhumbLeg leg = rhumbLeg(here, writtenPosition(route.waypoints[i + 1]));
            if (leg.lengthM > 0.0)
                feature->SetField("course_deg", std::fmod(rounded(leg.courseDeg), 360.0));
            feature->SetField("leg_length_m", rounded(leg.lengthM));
        }
        auto point = std::make_unique<OGRPoint>(here.longitudeDeg(), here.latitudeDeg());
        if (!route.depthsM.empty())
        {
            feature->SetField("depth_m", rounded(route.depthsM[i]));
            point->setZ(-route.depthsM[i]);
        }
        writer.write(*feature, std::move(point));
    }
}

void nameCell(OGRFeature &feature, const Lattice &lattice, OffsetCoord cell)
{
    const auto set = [&feature](const char *name, std::int64_t value)
    {
        feature.SetField(name, static_cast<GIntBig>(value));
    };
    if (lattice.squares() != nullptr)
    {
        set("column", cell.column);
        set("row", cell.row);
        return;
    }
    const HexCoord cube = toCube(cell);
    set("q", cube.q);
    set("r", cube.r());
    set("s", cube.s);
}

void writeBlockedCells(FeatureWriter &writer, const Occupancy &blocked, const Projection &projection)
{
    const Lattice &lattice = blocked.lattice();
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < lattice.columns(); ++column)
        {
            const OffsetCoord cell{column, row};
            if (blocked.isFree(cell))
                continue;
            const auto feature = writer.feature("blocked_cell");
            nameCell(*feature, lattice, cell);
            writer.write(*feature, polygonOf(lattice, cell, projection));
        }
}

void requireWritable(const RouteFileContent &content)
{
    for (const GeoRoute *line : {content.route, content.rawPath})
        if (line != nullptr && line->waypoints.size() < 2)
            failBecause("a line of " + std::to_string(line->waypoints.size()) + " waypoints is none");
    for (const GeoRoute *line : {content.route, content.rawPath})
        if (line != nullptr && !line->depthsM.empty() && line->depthsM.size() != line->waypoints.size())
            failBecause(std::to_string(line->depthsM.size()) + " depths are not those of " +
                        std::to_string(line->waypoints.size()) + " waypoints");
    if (content.blocked != nullptr && content.projection == nullptr)
        failBecause("blocked cells need a projection");
}

/// The driver doesn't notice when a disk runs full; its file then lacks the end.
void requireComplete(const PartFile &file)
{
    const std::string end = "\n]\n}\n";
    std::ifstream in(file.name(), std::ios::binary);
    in.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
    std::string found(end.size(), '\0');
    in.read(found.data(), static_cast<std::streamsize>(found.size()));
    if (!in || found != end)
        failBecause("the file came out incomplete, as on a full disk");
}

void writeFile(const PartFile &file, const RouteFileContent &content)
{
    const DriverMessages messages;
    FeatureWriter writer(file, messages);
    addFields(writer, content);
    if (content.route != nullptr)
    {
        writeRoute(writer, content);
        writeWaypoints(writer, *content.route);
    }
    if (content.rawPath != nullptr)
        writer.write(*writer.feature("raw_path"), lineOf(*content.rawPath));
    if (content.blocked != nullptr)
        writeBlockedCells(writer, *content.blocked, *content.projection);
    writer.close();
}

}  // namespace

void writeGeoJson(const std::string &path, const RouteFileContent &content)
{
    try
    {
        requireWritable(content);
        const PartFile file(path);
        writeFile(file, content);
        requireComplete(file);
        file.takePlace();
    }
    catch (const PositionError &error)
    {
        throw WriteError("can't write " + path + ": " + error.what());
    }
    catch (const PartFile::Failure &error)
    {
        throw WriteError("can't write " + path + ": " + error.what());
    }
}

}  // namespace seahex
