#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace seahex::test
{

/// A folder of its own that is removed with all that is in it.
class TemporaryFolder
{
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    const std::filesystem::path &path() const { return path_; }
    std::filesystem::path operator/(const std::string &name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

/// An attribute; a list of texts becomes a list field where the format has one.
using TestValue = std::variant<int, double, std::string, std::vector<std::string>>;

struct TestFeature
{
    std::string wkt;  ///< x = longitude, y = latitude; empty for none
    std::vector<std::pair<std::string, TestValue>> attributes;
};

struct TestLayer
{
    std::string name;  ///< "WRECKS"
    std::vector<TestFeature> features;
};

enum class TestFormat
{
    GeoPackage,  ///< one file, path as given
    GeoJson,     ///< a folder with one file a layer
    Shapefile    ///< the same
};

/// Writes a chart through OGR.
/// @param epsg  coordinate system of the WKT; 0 for none
/// @throws std::runtime_error if OGR refuses
void writeChart(const std::filesystem::path &path, const std::vector<TestLayer> &layers,
                TestFormat format = TestFormat::GeoPackage, int epsg = 4326);

std::string readBytes(const std::filesystem::path &path);
void writeBytes(const std::filesystem::path &path, const std::string &bytes);

/// Where the records of an ISO 8211 file (which S-57 cells are) begin; the last entry is the file's length.
std::vector<std::size_t> recordStarts(const std::string &bytes);

/// "POLYGON ((...))" of a box.
std::string boxWkt(double west, double south, double east, double north);

}  // namespace seahex::test
