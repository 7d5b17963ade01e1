#include "support/TestCharts.h"

#include <ogrsf_frmts.h>

#include <atomic>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include <unistd.h>

namespace seahex::test
{
namespace
{

namespace fs = std::filesystem;

struct Close
{
    void operator()(GDALDataset *dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Close>;

OGRFieldType typeOf(const TestValue &value, TestFormat format)
{
    if (std::holds_alternative<int>(value))
        return OFTInteger;
    if (std::holds_alternative<double>(value))
        return OFTReal;
    // Shapefiles have no lists: ogr2ogr writes them as "(2:7,14)" into a text.
    const bool isText = std::holds_alternative<std::string>(value) || format == TestFormat::Shapefile;
    return isText ? OFTString : OFTStringList;
}

void setField(OGRFeature &feature, const std::string &name, const TestValue &value)
{
    if (const int *number = std::get_if<int>(&value))
        feature.SetField(name.c_str(), *number);
    else if (const double *real = std::get_if<double>(&value))
        feature.SetField(name.c_str(), *real);
    else if (const std::string *text = std::get_if<std::string>(&value))
        feature.SetField(name.c_str(), text->c_str());
    else
    {
        const auto &items = std::get<std::vector<std::string>>(value);
        CPLStringList list;
        std::string joined;
        for (const std::string &item : items)
        {
            list.AddString(item.c_str());
            joined += (joined.empty() ? "" : ",") + item;
        }
        if (feature.GetFieldDefnRef(feature.GetFieldIndex(name.c_str()))->GetType() == OFTStringList)
            feature.SetField(name.c_str(), list.List());
        else
            feature.SetField(name.c_str(), ("(" + std::to_string(items.size()) + ":" + joined + ")").c_str());
    }
}

std::unique_ptr<OGRGeometry> geometryOf(const std::string &wkt)
{
    OGRGeometry *geometry = nullptr;
    if (!wkt.empty() && OGRGeometryFactory::createFromWkt(wkt.c_str(), nullptr, &geometry) != OGRERR_NONE)
        throw std::runtime_error("no geometry: " + wkt);
    return std::unique_ptr<OGRGeometry>(geometry);
}

/// Shapefiles hold one kind of geometry, so theirs follows the first feature.
OGRwkbGeometryType layerType(const TestLayer &layer, TestFormat format)
{
    if (format != TestFormat::Shapefile || layer.features.empty())
        return wkbUnknown;
    const std::unique_ptr<OGRGeometry> geometry = geometryOf(layer.features.front().wkt);
    return geometry ? geometry->getGeometryType() : wkbUnknown;
}

void writeLayer(GDALDataset &dataset, const TestLayer &layer, TestFormat format, int epsg)
{
    OGRSpatialReference frame;
    frame.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (epsg != 0)
        frame.importFromEPSG(epsg);
    OGRLayer *out =
        dataset.CreateLayer(layer.name.c_str(), epsg == 0 ? nullptr : &frame, layerType(layer, format), nullptr);
    if (out == nullptr)
        throw std::runtime_error("layer " + layer.name + " can't be made");
    for (const TestFeature &feature : layer.features)
        for (const auto &[name, value] : feature.attributes)
            if (out->GetLayerDefn()->GetFieldIndex(name.c_str()) < 0)
            {
                OGRFieldDefn field(name.c_str(), typeOf(value, format));
                out->CreateField(&field);
            }
    for (const TestFeature &feature : layer.features)
    {
        OGRFeature record(out->GetLayerDefn());
        for (const auto &[name, value] : feature.attributes)
            setField(record, name, value);
        record.SetGeometryDirectly(geometryOf(feature.wkt).release());
        if (out->CreateFeature(&record) != OGRERR_NONE)
            throw std::runtime_error("a feature of layer " + layer.name + " can't be written");
    }
}

Dataset create(const char *driverName, const fs::path &path)
{
    GDALAllRegister();
    GDALDriver *driver = GetGDALDriverManager()->GetDriverByName(driverName);
    if (driver == nullptr)
        throw std::runtime_error(std::string("no driver ") + driverName);
    Dataset dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!dataset)
        throw std::runtime_error("'" + path.string() + "' can't be written");
    return dataset;
}

}  // namespace

TemporaryFolder::TemporaryFolder()
{
    static std::atomic<int> number{0};
    path_ = fs::temp_directory_path() /
            ("seahex-test-" + std::to_string(::getpid()) + "-" + std::to_string(number.fetch_add(1)));
    fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code error;
    fs::remove_all(path_, error);
}

void writeChart(const fs::path &path, const std::vector<TestLayer> &layers, TestFormat format, int epsg)
{
    if (format == TestFormat::GeoPackage)
    {
        const Dataset dataset = create("GPKG", path);
        for (const TestLayer &layer : layers)
            writeLayer(*dataset, layer, format, epsg);
        return;
    }
    const bool isJson = format == TestFormat::GeoJson;
    fs::create_directories(path);
    for (const TestLayer &layer : layers)
    {
        const Dataset dataset =
            create(isJson ? "GeoJSON" : "ESRI Shapefile", path / (layer.name + (isJson ? ".geojson" : ".shp")));
        writeLayer(*dataset, layer, format, epsg);
    }
}

std::string readBytes(const fs::path &path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    if (!file)
        throw std::runtime_error("'" + path.string() + "' can't be read");
    return bytes.str();
}

void writeBytes(const fs::path &path, const std::string &bytes)
{
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!file)
        throw std::runtime_error("'" + path.string() + "' can't be written");
}

std::vector<std::size_t> recordStarts(const std::string &bytes)
{
    constexpr std::size_t LENGTH_DIGITS = 5;
    std::vector<std::size_t> starts{0};
    while (starts.back() < bytes.size())
        starts.push_back(starts.back() + std::stoul(bytes.substr(starts.back(), LENGTH_DIGITS)));
    return starts;
}

std::string boxWkt(double west, double south, double east, double north)
{
    std::ostringstream text;
    text.precision(12);
    text << "POLYGON ((" << west << ' ' << south << ',' << east << ' ' << south << ',' << east << ' ' << north << ','
         << west << ' ' << north << ',' << west << ' ' << south << "))";
    return text.str();
}

}  // namespace seahex::test
