#include "support/ChartOracle.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>

#include <cpl_error.h>
#include <cpl_quad_tree.h>
#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

namespace seahex::test
{

namespace
{

// ------------------------------------------------------------------------------------------------ errors, numbers

/// While it lives, GDAL's and GEOS' messages on this thread come here. A predicate that failed inside GEOS comes out
/// of OGR as "false", which a judge must not take for an acquittal: check() turns it into an exception.
class ErrorTrap
{
public:
    explicit ErrorTrap(std::string what) : what_(std::move(what)) { CPLPushErrorHandlerEx(&ErrorTrap::record, this); }
    ~ErrorTrap() { CPLPopErrorHandler(); }
    ErrorTrap(const ErrorTrap &) = delete;
    ErrorTrap &operator=(const ErrorTrap &) = delete;

    void check() const
    {
        if (!failure_.empty())
            throw std::runtime_error(what_ + ": " + failure_);
    }

private:
    static void CPL_STDCALL record(CPLErr severity, CPLErrorNum, const char *message)
    {
        auto *trap = static_cast<ErrorTrap *>(CPLGetErrorHandlerUserData());
        if (severity >= CE_Failure && trap->failure_.empty())
            trap->failure_ = message;
    }

    std::string what_;
    std::string failure_;
};

std::string text(double value)
{
    std::ostringstream out;
    out << value;
    return out.str();
}

/// Depths meet as whole micrometres: 1.1 + 0.7 is 1.8, which in doubles it is not.
std::int64_t micrometres(double metres)
{
    return std::llround(metres * 1e6);
}

bool shallower(double depthM, double requiredM)
{
    return micrometres(depthM) < micrometres(requiredM);
}
bool notDeeper(double depthM, double requiredM)
{
    return micrometres(depthM) <= micrometres(requiredM);
}

// ------------------------------------------------------------------------------------------------ attributes

std::optional<double> parse(const char *written)
{
    char *end = nullptr;
    const double value = std::strtod(written, &end);
    if (end == written || !std::isfinite(value))
        return std::nullopt;
    return value;
}

/// The values of an attribute, however the source stores it: S-57's lists are string lists, other sources join them
/// by commas, and single codes are numbers. Empty if the attribute is absent, null or blank.
std::vector<double> values(const OGRFeature &feature, const char *attribute)
{
    std::vector<double> found;
    const int field = feature.GetFieldIndex(attribute);
    if (field < 0 || !feature.IsFieldSetAndNotNull(field))
        return found;
    const OGRFieldType type = feature.GetFieldDefnRef(field)->GetType();
    if (type == OFTInteger || type == OFTInteger64 || type == OFTReal)
    {
        found.push_back(feature.GetFieldAsDouble(field));
        return found;
    }
    const auto addWritten = [&found](const char *written)
    {
        if (const auto value = parse(written))
            found.push_back(*value);
    };
    if (type == OFTIntegerList)
    {
        int count = 0;
        const int *list = feature.GetFieldAsIntegerList(field, &count);
        found.assign(list, list + count);
    }
    else if (type == OFTStringList)
    {
        for (char **item = feature.GetFieldAsStringList(field); item != nullptr && *item != nullptr; ++item)
            addWritten(*item);
    }
    else
    {
        const CPLStringList items(CSLTokenizeString2(feature.GetFieldAsString(field), ",", 0));
        for (int i = 0; i < items.size(); ++i)
            addWritten(items[i]);
    }
    return found;
}

std::optional<double> number(const OGRFeature &feature, const char *attribute)
{
    const auto found = values(feature, attribute);
    return found.empty() ? std::nullopt : std::make_optional(found.front());
}

bool has(const OGRFeature &feature, const char *attribute, std::initializer_list<int> wanted)
{
    const auto found = values(feature, attribute);
    return std::any_of(found.begin(), found.end(),
                       [&](double value)
                       { return std::find(wanted.begin(), wanted.end(), static_cast<int>(value)) != wanted.end(); });
}

// ------------------------------------------------------------------------------------------------ plane geometry

struct Point
{
    double x;
    double y;
};

/// Metres per degree on WGS-84 at a latitude: the frame in which short distances around it are measured.
struct MetreFrame
{
    explicit MetreFrame(double latitudeDeg)
    {
        const double radian = std::acos(-1.0) / 180.0;
        const double a = 6378137.0;
        const double e2 = 0.0066943799901413165;
        const double sine = std::sin(latitudeDeg * radian);
        const double w = std::sqrt(1.0 - e2 * sine * sine);
        perDegree.x = radian * a / w * std::cos(latitudeDeg * radian);
        perDegree.y = radian * a * (1.0 - e2) / (w * w * w);
    }

    Point operator()(const Point &degrees) const { return {degrees.x * perDegree.x, degrees.y * perDegree.y}; }

    Point perDegree{};
};

double distance(const Point &p, const Point &a, const Point &b)
{
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double squared = dx * dx + dy * dy;
    double along = squared > 0.0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared : 0.0;
    along = std::clamp(along, 0.0, 1.0);
    return std::hypot(p.x - (a.x + along * dx), p.y - (a.y + along * dy));
}

/// Distance of two segments that are known not to cross.
double distance(const Point &a, const Point &b, const Point &c, const Point &d)
{
    return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

CPLRectObj boxAround(const Point &a, const Point &b)
{
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}

/// The box grown, in degrees, by at least so many metres on every side.
CPLRectObj grown(CPLRectObj box, double metres)
{
    const double dy = metres / 110000.0 + 1e-9;  // a degree of latitude is never under 110,574 m
    const double highest = std::min(89.0, std::max(std::abs(box.miny), std::abs(box.maxy)) + dy);
    const double dx = metres / MetreFrame(highest).perDegree.x + 1e-9;
    return {box.minx - dx, box.miny - dy, box.maxx + dx, box.maxy + dy};
}

CPLRectObj boxOf(const OGRGeometry &geometry)
{
    OGREnvelope envelope;
    geometry.getEnvelope(&envelope);
    return {envelope.MinX, envelope.MinY, envelope.MaxX, envelope.MaxY};
}

/// Boxes by number, found by overlap: GDAL's quadtree over a list that stays where it is.
class BoxIndex
{
public:
    void build(std::vector<CPLRectObj> boxes)
    {
        boxes_ = std::move(boxes);
        if (boxes_.empty())
            return;
        CPLRectObj all = boxes_.front();
        for (const CPLRectObj &box : boxes_)
            all = {std::min(all.minx, box.minx), std::min(all.miny, box.miny), std::max(all.maxx, box.maxx),
                   std::max(all.maxy, box.maxy)};
        tree_.reset(CPLQuadTreeCreate(&all, [](const void *feature, CPLRectObj *bounds)
                                      { *bounds = *static_cast<const CPLRectObj *>(feature); }));
        CPLQuadTreeSetMaxDepth(tree_.get(), CPLQuadTreeGetAdvisedMaxDepth(static_cast<int>(boxes_.size())));
        for (CPLRectObj &box : boxes_)
            CPLQuadTreeInsert(tree_.get(), &box);
    }

    std::vector<std::size_t> overlapping(const CPLRectObj &area) const
    {
        std::vector<std::size_t> found;
        if (!tree_)
            return found;
        int count = 0;
        void **hits = CPLQuadTreeSearch(tree_.get(), &area, &count);
        for (int i = 0; i < count; ++i)
            found.push_back(static_cast<std::size_t>(static_cast<const CPLRectObj *>(hits[i]) - boxes_.data()));
        CPLFree(hits);
        std::sort(found.begin(), found.end());
        return found;
    }

private:
    struct Destroy
    {
        void operator()(CPLQuadTree *tree) const { CPLQuadTreeDestroy(tree); }
    };
    std::vector<CPLRectObj> boxes_;
    std::unique_ptr<CPLQuadTree, Destroy> tree_;
};

OGRPreparedGeometryUniquePtr prepare(const OGRGeometryUniquePtr &geometry)
{
    OGRPreparedGeometryUniquePtr prepared(OGRCreatePreparedGeometry(OGRGeometry::ToHandle(geometry.get())));
    if (!prepared)
        throw std::runtime_error("GEOS can't prepare a geometry");
    return prepared;
}

bool intersects(const OGRPreparedGeometryUniquePtr &prepared, const OGRGeometryUniquePtr &other)
{
    return OGRPreparedGeometryIntersects(prepared.get(), OGRGeometry::ToHandle(other.get())) != 0;
}

bool contains(const OGRPreparedGeometryUniquePtr &prepared, const OGRGeometryUniquePtr &other)
{
    return OGRPreparedGeometryContains(prepared.get(), OGRGeometry::ToHandle(other.get())) != 0;
}

/// Calls back with every point, line string and polygon that a geometry is made of.
template <class Visitor>
void forEachPart(const OGRGeometry &geometry, const Visitor &visit)
{
    if (geometry.IsEmpty())
        return;
    if (OGR_GT_IsSubClassOf(wkbFlatten(geometry.getGeometryType()), wkbGeometryCollection))
    {
        for (const OGRGeometry *member : *geometry.toGeometryCollection())
            forEachPart(*member, visit);
        return;
    }
    visit(geometry);
}

struct Leg
{
    Leg(const Point &from, const Point &to) : a(from), b(to), start(new OGRPoint(a.x, a.y)), end(new OGRPoint(b.x, b.y))
    {
        if (a.x == b.x && a.y == b.y)
        {
            line.reset(start->clone());
            return;
        }
        auto drawn = std::make_unique<OGRLineString>();
        drawn->addPoint(a.x, a.y);
        drawn->addPoint(b.x, b.y);
        line.reset(drawn.release());
    }

    bool passes(const Point &point, double radiusM) const
    {
        if (distance(point, a, b) < 1e-9)
            return true;
        const MetreFrame metres(point.y);
        return radiusM > 0.0 && distance(metres(point), metres(a), metres(b)) <= radiusM;
    }

    Point a;
    Point b;
    OGRGeometryUniquePtr start;
    OGRGeometryUniquePtr end;
    OGRGeometryUniquePtr line;
};

std::vector<Leg> legsOf(const std::vector<LatLon> &route)
{
    std::vector<Point> points;
    for (std::size_t i = 0; i < route.size(); ++i)
    {
        const auto &[latitude, longitude] = route[i];
        if (!(std::abs(latitude) <= 90.0) || !(std::abs(longitude) <= 180.0))
            throw std::runtime_error("waypoint " + std::to_string(i) + " (latitude " + text(latitude) + ", longitude " +
                                     text(longitude) + " degrees) is not a position");
        points.push_back({longitude, latitude});
    }
    std::vector<Leg> legs;
    if (points.size() == 1)
        legs.emplace_back(points.front(), points.front());
    for (std::size_t i = 1; i < points.size(); ++i)
        legs.emplace_back(points[i - 1], points[i]);
    return legs;
}

// ------------------------------------------------------------------------------------------------ sets of objects

struct Object
{
    std::string className;
    std::string label;  ///< class and LNAM
    std::string reason;
    bool isPoint = false;
    std::optional<double> drval1;
};

/// Chart objects with their geometries, asked by leg. Every geometry is split into points, lines and polygons.
class ObjectSet
{
public:
    void add(Object object, const OGRGeometry &geometry)
    {
        const std::size_t number = objects_.size();
        object.isPoint = true;
        forEachPart(geometry,
                    [&](const OGRGeometry &part)
                    {
                        if (wkbFlatten(part.getGeometryType()) == wkbPoint)
                        {
                            points_.push_back({number, {part.toPoint()->getX(), part.toPoint()->getY()}});
                            return;
                        }
                        object.isPoint = false;
                        OGRGeometryUniquePtr copy(part.getLinearGeometry());
                        copy->flattenTo2D();
                        auto prepared = prepare(copy);
                        shapes_.push_back({number, std::move(copy), std::move(prepared)});
                    });
        objects_.push_back(std::move(object));
    }

    void buildIndex()
    {
        std::vector<CPLRectObj> pointBoxes;
        for (const PointPart &point : points_)
            pointBoxes.push_back(boxAround(point.at, point.at));
        pointIndex_.build(std::move(pointBoxes));
        std::vector<CPLRectObj> shapeBoxes;
        for (const ShapePart &shape : shapes_)
            shapeBoxes.push_back(boxOf(*shape.geometry));
        shapeIndex_.build(std::move(shapeBoxes));
    }

    /// Numbers of the objects that a leg touches, each once.
    std::set<std::size_t> touched(const Leg &leg, double pointRadiusM) const
    {
        auto found = shapesTouched(leg.line);
        for (const std::size_t i : pointIndex_.overlapping(grown(boxAround(leg.a, leg.b), pointRadiusM)))
            if (leg.passes(points_[i].at, pointRadiusM))
                found.insert(points_[i].object);
        return found;
    }

    /// Numbers of the objects whose lines or polygons a geometry touches.
    std::set<std::size_t> shapesTouched(const OGRGeometryUniquePtr &geometry) const
    {
        std::set<std::size_t> found;
        for (const std::size_t i : shapeIndex_.overlapping(boxOf(*geometry)))
            if (found.count(shapes_[i].object) == 0 && intersects(shapes_[i].prepared, geometry))
                found.insert(shapes_[i].object);
        return found;
    }

    /// Calls back with every edge (a point is an edge without length) and its object's number.
    template <class Visitor>
    void forEachEdge(const Visitor &visit) const
    {
        for (const PointPart &point : points_)
            visit(point.at, point.at, point.object);
        for (const ShapePart &shape : shapes_)
        {
            const auto walk = [&](const OGRSimpleCurve &curve)
            {
                for (int i = 1; i < curve.getNumPoints(); ++i)
                    visit(Point{curve.getX(i - 1), curve.getY(i - 1)}, Point{curve.getX(i), curve.getY(i)},
                          shape.object);
            };
            if (wkbFlatten(shape.geometry->getGeometryType()) == wkbLineString)
                walk(*shape.geometry->toLineString());
            else
                for (const OGRLinearRing *ring : *shape.geometry->toPolygon())
                    walk(*ring);
        }
    }

    const std::vector<Object> &objects() const { return objects_; }

private:
    struct PointPart
    {
        std::size_t object;
        Point at;
    };
    struct ShapePart
    {
        std::size_t object;
        OGRGeometryUniquePtr geometry;
        OGRPreparedGeometryUniquePtr prepared;
    };

    std::vector<Object> objects_;
    std::vector<PointPart> points_;
    std::vector<ShapePart> shapes_;
    BoxIndex pointIndex_;
    BoxIndex shapeIndex_;
};

// ------------------------------------------------------------------------------------------------ the law

using Names = std::set<std::string>;

const Names &groupOneNames()
{
    static const Names names = {"DEPARE", "DRGARE", "LNDARE", "UNSARE", "PONTON", "FLODOC", "HULKES"};
    return names;
}

const Names &alwaysBlocking()
{
    static const Names names = {"LNDARE", "UNSARE", "PONTON", "HULKES", "FLODOC", "COALNE", "SLCONS", "CAUSWY",
                                "DAMCON", "DYKCON", "GATCON", "DRYDOC", "LOKBSN", "PILPNT", "PYLONS", "OFSPLF",
                                "FSHFAC", "FORSTC", "OILBAR", "LOGPON", "ICEARE", "LITFLT", "LITVES", "DAYMAR"};
    return names;
}

/// Classes whose attributes decide.
const Names &perhapsBlocking()
{
    static const Names names = {"DEPARE", "DRGARE", "SOUNDG", "OBSTRN", "UWTROC",
                                "WRECKS", "MORFAC", "MARCUL", "PIPSOL"};
    return names;
}

const Names &overheadAndRegulation()
{
    static const Names names = {"BRIDGE", "CBLOHD", "PIPOHD", "CONVYR", "CRANES", "TUNNEL", "RESARE",
                                "ACHARE", "DMPGRD", "MARCUL", "MIPARE", "OSPARE", "PRCARE", "ISTZNE",
                                "CBLARE", "PIPARE", "FAIRWY", "DRGARE", "TSSLPT", "TSEZNE", "TSELNE",
                                "TSSRON", "TSSCRS", "TSSBND", "CTNARE", "SPLARE", "SUBTLN", "FERYRT",
                                "HRBARE", "CTSARE", "ACHBRT", "DWRTPT", "TWRTPT", "RECTRC", "RCRTCL"};
    return names;
}

bool isBuoyOrBeacon(const std::string &name)
{
    return name.size() == 6 && (name.compare(0, 3, "BOY") == 0 || name.compare(0, 3, "BCN") == 0);
}

bool mayBlock(const std::string &name)
{
    return alwaysBlocking().count(name) != 0 || perhapsBlocking().count(name) != 0 || isBuoyOrBeacon(name);
}

using Reason = std::optional<std::string>;  ///< empty: does not block

class Judge
{
public:
    Judge(const OracleVessel &vessel, const ObjectSet &seabed)
        : requiredM_(vessel.draughtM + vessel.underKeelClearanceM), seabed_(seabed)
    {
    }

    Reason operator()(const std::string &name, const OGRFeature &feature, const OGRGeometryUniquePtr &geometry) const
    {
        if (name == "DEPARE" || name == "DRGARE")
            return depthArea(feature);
        if (name == "SOUNDG")
            return sounding(feature, *geometry);
        if (name == "OBSTRN" || name == "UWTROC" || name == "WRECKS")
            return danger(feature, geometry);
        if (name == "MORFAC")
        {
            const bool spared = number(feature, "CATMOR") && !has(feature, "CATMOR", {1, 2, 3, 5, 7});
            return spared ? std::nullopt : Reason("mooring facility");
        }
        if (name == "MARCUL")
        {
            const auto valsou = number(feature, "VALSOU");
            const bool spared = valsou && !notDeeper(*valsou, requiredM_) && has(feature, "WATLEV", {3});
            return spared ? std::nullopt : Reason("marine farm");
        }
        if (name == "PIPSOL")
        {
            const auto drval1 = number(feature, "DRVAL1");
            return drval1 && notDeeper(*drval1, requiredM_) ? Reason("DRVAL1 " + text(*drval1) + " m") : std::nullopt;
        }
        return mayBlock(name) ? Reason("always") : std::nullopt;
    }

private:
    Reason depthArea(const OGRFeature &feature) const
    {
        const auto drval1 = number(feature, "DRVAL1");
        if (!drval1)
            return "no DRVAL1";
        return shallower(*drval1, requiredM_) ? Reason("DRVAL1 " + text(*drval1) + " m") : std::nullopt;
    }

    Reason sounding(const OGRFeature &feature, const OGRGeometry &geometry) const
    {
        auto depth = number(feature, "DEPTH");
        if (!depth && geometry.Is3D() && wkbFlatten(geometry.getGeometryType()) == wkbPoint)
            depth = geometry.toPoint()->getZ();
        if (!depth)
            return "no depth";
        return notDeeper(*depth, requiredM_) ? Reason(text(*depth) + " m") : std::nullopt;
    }

    Reason danger(const OGRFeature &feature, const OGRGeometryUniquePtr &geometry) const
    {
        if (has(feature, "WATLEV", {7}))
            return "WATLEV 7, floating";
        if (has(feature, "CATOBS", {8, 10}))
            return "CATOBS " + text(*number(feature, "CATOBS")) + ", boom";
        if (const auto valsou = number(feature, "VALSOU"))
            return notDeeper(*valsou, requiredM_) ? Reason("VALSOU " + text(*valsou) + " m") : std::nullopt;
        // Foul ground holds anchors, not keels, unless its water level says that it comes near the surface.
        if (has(feature, "CATOBS", {7}) && !has(feature, "WATLEV", {1, 2, 4, 5, 6}))
            return std::nullopt;
        const double depth = depthInsteadOfValsou(feature, geometry);
        return notDeeper(depth, requiredM_) ? Reason("no VALSOU, taken as " + text(depth) + " m") : std::nullopt;
    }

    /// S-52, conditional symbology procedures OBSTRN04 and WRECKS02, in their order.
    double depthInsteadOfValsou(const OGRFeature &feature, const OGRGeometryUniquePtr &geometry) const
    {
        const bool alwaysUnderWater = has(feature, "WATLEV", {3});
        const auto surrounding = leastDepthUnder(geometry);
        if (alwaysUnderWater && has(feature, "EXPSOU", {1, 3}) && surrounding)
            return *surrounding;
        if (has(feature, "CATOBS", {6}))
            return 0.01;
        if (has(feature, "CATWRK", {1}) && surrounding && !shallower(*surrounding, requiredM_))
            return 20.0;
        if (has(feature, "CATWRK", {2}))
            return 0.0;
        if (has(feature, "CATWRK", {4, 5}))
            return -15.0;
        if (has(feature, "WATLEV", {5}))
            return 0.0;
        return alwaysUnderWater ? 0.01 : -15.0;
    }

    /// Least DRVAL1 of the depth areas that the object touches, an unknown one as -1; empty over unsurveyed water,
    /// be it in part, and where there is no depth area.
    std::optional<double> leastDepthUnder(const OGRGeometryUniquePtr &geometry) const
    {
        std::optional<double> least;
        for (const std::size_t i : seabed_.shapesTouched(geometry))
        {
            const Object &area = seabed_.objects()[i];
            if (area.className == "UNSARE")
                return std::nullopt;
            least = std::min(least.value_or(std::numeric_limits<double>::infinity()), area.drval1.value_or(-1.0));
        }
        return least;
    }

    double requiredM_;
    const ObjectSet &seabed_;
};

// ------------------------------------------------------------------------------------------------ reading

struct Record
{
    std::string className;
    OGRFeatureUniquePtr feature;
    OGRGeometryUniquePtr geometry;  ///< with its Z

    std::string label() const
    {
        const int field = feature->GetFieldIndex("LNAM");
        if (field >= 0 && feature->IsFieldSetAndNotNull(field))
            return className + " " + feature->GetFieldAsString(field);
        return className + " fid " + std::to_string(feature->GetFID());
    }

    bool isArea() const { return OGR_GT_IsSurface(geometry->getGeometryType()) || isMultiPolygon(); }
    bool isMultiPolygon() const
    {
        return OGR_GT_IsSubClassOf(wkbFlatten(geometry->getGeometryType()), wkbMultiSurface) != 0;
    }
};

GDALDatasetUniquePtr open(const std::string &path)
{
    GDALAllRegister();
    const ErrorTrap trap("can't open the chart " + path);
    GDALDriver *driver = GDALDriver::FromHandle(GDALIdentifyDriver(path.c_str(), nullptr));
    CPLStringList options;
    if (driver != nullptr && EQUAL(driver->GetDescription(), "S57"))
        for (const char *option : {"UPDATES=APPLY", "SPLIT_MULTIPOINT=ON", "ADD_SOUNDG_DEPTH=ON", "LNAM_REFS=ON"})
            options.AddString(option);
    GDALDatasetUniquePtr dataset(
        GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, options.List(), nullptr));
    trap.check();
    if (!dataset)
        throw std::runtime_error("can't open the chart " + path + ": no OGR driver takes it");
    return dataset;
}

void requireDegrees(OGRLayer &layer, const std::string &path)
{
    if (layer.GetSpatialRef() != nullptr && layer.GetSpatialRef()->IsGeographic() == 0)
        throw std::runtime_error("layer " + std::string(layer.GetName()) + " of " + path + " is not in degrees");
}

struct Source
{
    std::vector<Record> records;
    double multiplier = 1e7;  ///< COMF; what every producer uses unless the cell says otherwise
};

Source read(const std::string &path)
{
    const auto dataset = open(path);
    const ErrorTrap trap("can't read the chart " + path);
    Source source;
    for (OGRLayer *layer : dataset->GetLayers())
    {
        std::string name = layer->GetName();
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
        if (!mayBlock(name) && overheadAndRegulation().count(name) == 0 && name != "M_COVR" && name != "DSID")
            continue;
        requireDegrees(*layer, path);
        for (auto &feature : *layer)  // never by the layer's count: it is -1 for split soundings
        {
            if (name == "DSID")
                source.multiplier = number(*feature, "DSPM_COMF").value_or(source.multiplier);
            OGRGeometryUniquePtr geometry(feature->StealGeometry());
            if (name != "DSID" && geometry && !geometry->IsEmpty())
                source.records.push_back({name, std::move(feature), std::move(geometry)});
        }
    }
    trap.check();
    return source;
}

// ------------------------------------------------------------------------------------------------ coverage, group 1

__extension__ typedef __int128 Wide;  // sums of products of 33-bit coordinates

std::int64_t twiceArea(const OGRLinearRing &ring, double multiplier)
{
    const auto grid = [multiplier](double degrees)
    {
        return static_cast<Wide>(std::llround(degrees * multiplier));
    };
    Wide sum = 0;
    for (int i = 1; i < ring.getNumPoints(); ++i)
        sum += grid(ring.getX(i - 1)) * grid(ring.getY(i)) - grid(ring.getX(i)) * grid(ring.getY(i - 1));
    return static_cast<std::int64_t>(sum < 0 ? -sum : sum);
}

std::int64_t twiceArea(const OGRGeometry &geometry, double multiplier)
{
    std::int64_t sum = 0;
    forEachPart(geometry,
                [&](const OGRGeometry &part)
                {
                    if (wkbFlatten(part.getGeometryType()) != wkbPolygon)
                        return;
                    const OGRPolygon &polygon = *part.toPolygon();
                    sum += twiceArea(*polygon.getExteriorRing(), multiplier);
                    for (int hole = 0; hole < polygon.getNumInteriorRings(); ++hole)
                        sum -= twiceArea(*polygon.getInteriorRing(hole), multiplier);
                });
    return sum;
}

class PolygonPile
{
public:
    void add(const OGRGeometry &geometry)
    {
        forEachPart(geometry,
                    [this](const OGRGeometry &part)
                    {
                        OGRGeometryUniquePtr copy(part.getLinearGeometry());
                        copy->flattenTo2D();
                        if (wkbFlatten(copy->getGeometryType()) == wkbPolygon)
                            pile_.addGeometry(copy.get());
                    });
    }

    OGRGeometryUniquePtr united() const
    {
        if (pile_.IsEmpty())
            return OGRGeometryUniquePtr(new OGRMultiPolygon);
        return OGRGeometryUniquePtr(pile_.UnionCascaded());
    }

private:
    OGRMultiPolygon pile_;
};

class Coverage
{
public:
    void set(OGRGeometryUniquePtr area)
    {
        area_ = std::move(area);
        preparedArea_ = prepare(area_);
        boundary_.reset(area_->Boundary());
        preparedBoundary_ = prepare(boundary_);
    }

    /// GEOS' "contains" wants a point in the interior in common, so that a leg along the edge needs a second look.
    bool covers(const Leg &leg) const
    {
        if (!intersects(preparedArea_, leg.start) || !intersects(preparedArea_, leg.end))
            return false;
        const bool isPoint = wkbFlatten(leg.line->getGeometryType()) == wkbPoint;
        return isPoint || contains(preparedArea_, leg.line) || contains(preparedBoundary_, leg.line);
    }

    const OGRGeometry &area() const { return *area_; }

private:
    OGRGeometryUniquePtr area_;
    OGRGeometryUniquePtr boundary_;
    OGRPreparedGeometryUniquePtr preparedArea_;
    OGRPreparedGeometryUniquePtr preparedBoundary_;
};

}  // namespace

// ------------------------------------------------------------------------------------------------ the oracle

struct ChartOracle::Chart
{
    Chart(const std::string &path, const OracleVessel &vessel);
    void readCoverage(const std::string &path, const Source &source);
    void readSeabed(const Source &source);
    void judgeObjects(const Source &source, const OracleVessel &vessel);
    void indexEdges();
    std::string accusation(std::size_t leg, std::size_t object, double pointRadiusM) const;
    std::string described(std::size_t object) const;
    void searchAround(const Point &p, const Point &q, std::size_t leg, NearestHazard &nearest) const;

    struct Edge
    {
        Point a;
        Point b;
        std::size_t object;
    };

    ObjectSet blocking;
    ObjectSet seabed;  ///< polygons of DEPARE, DRGARE, UNSARE
    ObjectSet aside;   ///< overhead and regulation
    Coverage coverage;
    GroupOneSums sums{0, 0};
    std::vector<Edge> edges;  ///< of blocking
    BoxIndex edgeIndex;
};

ChartOracle::Chart::Chart(const std::string &path, const OracleVessel &vessel)
{
    const Source source = read(path);
    const ErrorTrap trap("can't judge the chart " + path);
    readCoverage(path, source);
    readSeabed(source);
    judgeObjects(source, vessel);
    indexEdges();
    trap.check();
}

void ChartOracle::Chart::readCoverage(const std::string &path, const Source &source)
{
    PolygonPile covered;
    PolygonPile groupOne;
    for (const Record &record : source.records)
    {
        if (record.className == "M_COVR" && has(*record.feature, "CATCOV", {1}))
        {
            covered.add(*record.geometry);
            sums.coverage += twiceArea(*record.geometry, source.multiplier);
        }
        if (groupOneNames().count(record.className) != 0)
        {
            groupOne.add(*record.geometry);
            sums.groupOne += twiceArea(*record.geometry, source.multiplier);
        }
    }
    OGRGeometryUniquePtr area = covered.united();
    if (!area || area->IsEmpty())
        throw std::runtime_error("the chart " + path + " has no coverage (M_COVR with CATCOV 1)");
    const auto charted = groupOne.united();
    const OGRGeometryUniquePtr gaps(charted ? area->Difference(charted.get()) : nullptr);
    if (!gaps)
        throw std::runtime_error("GEOS can't subtract the group 1 areas of " + path + " from its coverage");
    forEachPart(*gaps,
                [this](const OGRGeometry &part)
                {
                    if (wkbFlatten(part.getGeometryType()) == wkbPolygon)
                        blocking.add({"GAP", "GAP", "coverage in no group 1 area", false, std::nullopt}, part);
                });
    coverage.set(std::move(area));
}

void ChartOracle::Chart::readSeabed(const Source &source)
{
    for (const Record &record : source.records)
    {
        const bool hasDepth = record.className == "DEPARE" || record.className == "DRGARE";
        if (record.isArea() && (hasDepth || record.className == "UNSARE"))
            seabed.add({record.className, record.label(), "", false, number(*record.feature, "DRVAL1")},
                       *record.geometry);
    }
    seabed.buildIndex();
}

void ChartOracle::Chart::judgeObjects(const Source &source, const OracleVessel &vessel)
{
    const Judge judge(vessel, seabed);
    for (const Record &record : source.records)
    {
        const std::string &name = record.className;
        if (const Reason reason = judge(name, *record.feature, record.geometry))
            blocking.add({name, record.label(), *reason, false, std::nullopt}, *record.geometry);
        const bool needsRestriction = name == "DRGARE" || name == "MARCUL";
        if (overheadAndRegulation().count(name) != 0 &&
            (!needsRestriction || !values(*record.feature, "RESTRN").empty()))
            aside.add({name, record.label(), "", false, std::nullopt}, *record.geometry);
    }
    blocking.buildIndex();
    aside.buildIndex();
}

void ChartOracle::Chart::indexEdges()
{
    std::vector<CPLRectObj> boxes;
    blocking.forEachEdge(
        [&](const Point &a, const Point &b, std::size_t object)
        {
            edges.push_back({a, b, object});
            boxes.push_back(boxAround(a, b));
        });
    edgeIndex.build(std::move(boxes));
}

std::string ChartOracle::Chart::accusation(std::size_t leg, std::size_t object, double pointRadiusM) const
{
    const Object &hazard = blocking.objects()[object];
    const std::string verb =
        hazard.isPoint && pointRadiusM > 0.0 ? " comes within " + text(pointRadiusM) + " m of " : " touches ";
    return "leg " + std::to_string(leg) + verb + described(object);
}

std::string ChartOracle::Chart::described(std::size_t object) const
{
    const Object &hazard = blocking.objects()[object];
    return hazard.label + " (" + hazard.reason + ")";
}

/// Replaces the nearest hazard if there is a nearer one around the piece p-q of a leg.
void ChartOracle::Chart::searchAround(const Point &p, const Point &q, std::size_t leg, NearestHazard &nearest) const
{
    const MetreFrame metres((p.y + q.y) / 2.0);
    // The window grows until it has found something that lies wholly within it, or can't better the best.
    for (double windowM = 100.0;; windowM *= 4.0)
    {
        const double reachM = std::min(windowM, nearest.distanceM);
        for (const std::size_t e : edgeIndex.overlapping(grown(boxAround(p, q), reachM)))
        {
            const double d = distance(metres(p), metres(q), metres(edges[e].a), metres(edges[e].b));
            if (d < nearest.distanceM)
                nearest = {d, leg, described(edges[e].object)};
        }
        if (nearest.distanceM <= windowM || windowM > 4e7)
            return;
    }
}

ChartOracle::ChartOracle(const std::string &chartPath, const OracleVessel &vessel)
    : chart_(std::make_unique<const Chart>(chartPath, vessel))
{
}

ChartOracle::~ChartOracle() = default;
ChartOracle::ChartOracle(ChartOracle &&) noexcept = default;
ChartOracle &ChartOracle::operator=(ChartOracle &&) noexcept = default;

std::vector<Violation> ChartOracle::violations(const std::vector<LatLon> &route) const
{
    return violationsWithin(route, 0.0);
}

std::vector<Violation> ChartOracle::violationsWithin(const std::vector<LatLon> &route, double pointRadiusM) const
{
    const ErrorTrap trap("can't judge the route");
    std::vector<Violation> found;
    const auto legs = legsOf(route);
    for (std::size_t i = 0; i < legs.size(); ++i)
    {
        if (!chart_->coverage.covers(legs[i]))
            found.push_back({i, "leg " + std::to_string(i) + " leaves the coverage"});
        for (const std::size_t object : chart_->blocking.touched(legs[i], pointRadiusM))
            found.push_back({i, chart_->accusation(i, object, pointRadiusM)});
    }
    trap.check();
    return found;
}

bool ChartOracle::blocked(double latitudeDeg, double longitudeDeg) const
{
    return !violations({{latitudeDeg, longitudeDeg}}).empty();
}

std::optional<double> ChartOracle::chartedDepth(double latitudeDeg, double longitudeDeg) const
{
    const ErrorTrap trap("can't find the charted depth");
    const auto legs = legsOf({{latitudeDeg, longitudeDeg}});
    std::optional<double> least;
    bool unknown = false;
    for (const std::size_t i : chart_->seabed.shapesTouched(legs.front().line))
    {
        const Object &area = chart_->seabed.objects()[i];
        if (area.className == "UNSARE")
            continue;
        unknown = unknown || !area.drval1;
        if (area.drval1)
            least = std::min(least.value_or(*area.drval1), *area.drval1);
    }
    trap.check();
    return unknown ? std::nullopt : least;
}

std::vector<std::pair<LatLon, LatLon>> ChartOracle::randomPairs(unsigned seed, std::size_t count, double minDepthM,
                                                                double minDistanceShare) const
{
    const auto apart = [](const LatLon &a, const LatLon &b)
    {
        const MetreFrame metres((a.first + b.first) / 2.0);
        return std::hypot((b.second - a.second) * metres.perDegree.x, (b.first - a.first) * metres.perDegree.y);
    };
    const CPLRectObj box = boxOf(chart_->coverage.area());
    const double leastM = minDistanceShare * apart({box.miny, box.minx}, {box.maxy, box.maxx});

    std::mt19937 generator(seed);  // its numbers are the same everywhere; those of std::uniform_* are not
    std::size_t drawsLeft = 20000 * count;
    const auto drawIn = [&generator](double low, double high)
    {
        return std::round((low + (high - low) * (static_cast<double>(generator()) / 4294967296.0)) * 1e7) / 1e7;
    };
    const auto draw = [&]() -> LatLon
    {
        for (; drawsLeft > 0; --drawsLeft)
        {
            const double latitude = drawIn(box.miny, box.maxy);
            const double longitude = drawIn(box.minx, box.maxx);
            const auto depth = chartedDepth(latitude, longitude);
            if (depth && !shallower(*depth, minDepthM) && !blocked(latitude, longitude))
                return {latitude, longitude};
        }
        throw std::runtime_error("found too few pairs of positions with " + text(minDepthM) + " m of water and " +
                                 text(leastM) + " m apart (seed " + std::to_string(seed) + ")");
    };

    std::vector<std::pair<LatLon, LatLon>> pairs;
    while (pairs.size() < count)
    {
        const LatLon from = draw();
        const LatLon to = draw();
        if (apart(from, to) >= leastM)
            pairs.emplace_back(from, to);
        else if (drawsLeft > 0)
            --drawsLeft;
    }
    return pairs;
}

std::vector<std::string> ChartOracle::crossedOverheadAndRegulation(const std::vector<LatLon> &route) const
{
    const ErrorTrap trap("can't judge the route");
    std::set<std::size_t> crossed;
    for (const Leg &leg : legsOf(route))
        crossed.merge(chart_->aside.touched(leg, 0.0));
    std::vector<std::string> labels;
    labels.reserve(crossed.size());
    for (const std::size_t object : crossed)
        labels.push_back(chart_->aside.objects()[object].label);
    trap.check();
    return labels;
}

NearestHazard ChartOracle::nearestHazard(const std::vector<LatLon> &route) const
{
    const ErrorTrap trap("can't measure the route");
    const auto legs = legsOf(route);
    NearestHazard nearest{std::numeric_limits<double>::infinity(), 0, "nothing blocks"};
    if (chart_->edges.empty())
        return nearest;
    for (std::size_t i = 0; i < legs.size(); ++i)
    {
        const auto touched = chart_->blocking.touched(legs[i], 0.0);
        if (!touched.empty())
            return {0.0, i, chart_->described(*touched.begin())};
    }
    trap.check();

    for (std::size_t i = 0; i < legs.size(); ++i)
    {
        // In pieces so short that one frame of metres serves each of them, and boxes around them stay small.
        const Point &a = legs[i].a;
        const Point &b = legs[i].b;
        const int pieces =
            std::max(1, static_cast<int>(std::ceil(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) / 0.01)));
        for (int k = 0; k < pieces; ++k)
        {
            const auto at = [&](double share)
            {
                return Point{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
            };
            const Point p = at(static_cast<double>(k) / pieces);
            const Point q = at((k + 1.0) / pieces);
            chart_->searchAround(p, q, i, nearest);
        }
    }
    return nearest;
}

GroupOneSums ChartOracle::groupOneSums() const
{
    return chart_->sums;
}

std::map<std::string, std::size_t> ChartOracle::blockingByClass() const
{
    std::map<std::string, std::size_t> counts;
    for (const Object &object : chart_->blocking.objects())
        ++counts[object.className];
    return counts;
}

}  // namespace seahex::test
