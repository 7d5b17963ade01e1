#include <seahex/io/BathymetryReader.h>

#include "support/Random.h"
#include "support/TestCharts.h"
#include "support/TestData.h"
#include "support/TestRasters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace seahex;
using namespace seahex::test;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Heights of a seabed that has no two nodes alike: 3 columns, 2 rows, north up, pixels of 10 by 20 m.
TestRaster smallRaster()
{
    TestRaster raster;
    raster.columns = 3;
    raster.rows = 2;
    raster.values = {-40, -50, -60, -10, -20, -30};
    raster.transform = {1000.0, 10.0, 0.0, 2000.0, 0.0, -20.0};
    return raster;
}

/// The refusal's words; empty if the raster is read.
std::string refusal(const std::filesystem::path &path, const BathymetryOptions &options = {})
{
    try
    {
        readBathymetry(path, options);
    }
    catch (const BathymetryError &error)
    {
        return error.what();
    }
    return "";
}

void expectRefusal(const std::string &words, const std::string &part)
{
    EXPECT_NE(words.find(part), std::string::npos) << "'" << words << "'";
    EXPECT_EQ(words.find('\n'), std::string::npos) << words;
}

class BathymetryReader : public ::testing::Test
{
protected:
    BathymetryRaster read(const TestRaster &raster, const BathymetryOptions &options = {})
    {
        return readBathymetry(write(raster), options);
    }
    std::string refusalOf(const TestRaster &raster, const BathymetryOptions &options = {})
    {
        const auto path = write(raster);
        const std::string words = refusal(path, options);
        expectRefusal(words, path.string());
        return words;
    }
    std::filesystem::path write(const TestRaster &raster)
    {
        auto path = folder / ("raster" + std::to_string(++count_));
        writeRaster(path, raster);
        return path;
    }

    TemporaryFolder folder;

private:
    int count_ = 0;
};

void expectSmallRaster(const Bathymetry &seabed)
{
    ASSERT_EQ(seabed.grid().columns(), 3);
    ASSERT_EQ(seabed.grid().rows(), 2);
    EXPECT_EQ(seabed.grid().southWest(), Point(1005.0, 1970.0)) << "the centre of the south-western pixel";
    EXPECT_EQ(seabed.grid().spacing(), Point(10.0, 20.0));
    const std::vector<float> depths = {10, 20, 30, 40, 50, 60};
    for (int i = 0; i < 6; ++i)
        EXPECT_EQ(seabed.nodeDepth(i % 3, i / 3), depths[static_cast<std::size_t>(i)]) << i;
}

TEST_F(BathymetryReader, pixelCentresAreNodesAndHeightsAreNegativeDepths)
{
    const BathymetryRaster raster = read(smallRaster());
    expectSmallRaster(*raster.seabed);
    EXPECT_FALSE(raster.projection) << "a raster in metres keeps its own";
    EXPECT_TRUE(raster.areHeights);
    EXPECT_EQ(raster.driver, "GTiff");
    EXPECT_EQ(raster.unknown, 0);
    EXPECT_EQ(raster.land, 0);
    EXPECT_EQ(raster.deepestM, 60.0);
}

TEST_F(BathymetryReader, rowsMayRunToTheNorth)
{
    TestRaster raster = smallRaster();
    raster.values = {-10, -20, -30, -40, -50, -60};
    raster.transform = {1000.0, 10.0, 0.0, 1960.0, 0.0, 20.0};
    expectSmallRaster(*read(raster).seabed);
}

TEST_F(BathymetryReader, depthsByOptionAndByWhatTheBandSays)
{
    TestRaster raster = smallRaster();
    for (double &value : raster.values)
        value = -value;
    BathymetryOptions options;
    options.values = RasterValues::Depths;
    expectSmallRaster(*read(raster, options).seabed);

    raster.driver = "netCDF";
    for (const auto &[key, value] :
         {std::pair("positive", "down"), std::pair("standard_name", "sea_floor_depth_below_mean_sea_level")})
    {
        raster.bandMetadata = {{key, value}};
        const BathymetryRaster automatic = read(raster);
        EXPECT_FALSE(automatic.areHeights) << key;
        expectSmallRaster(*automatic.seabed);
    }
    raster.bandMetadata = {{"positive", "up"}, {"standard_name", "depth"}};
    expectRefusal(refusalOf(raster), "none of its nodes is under water");
}

TEST_F(BathymetryReader, scaleOffsetAndDatumAreApplied)
{
    TestRaster raster = smallRaster();
    raster.type = GDT_Int16;
    raster.scale = 0.5;
    raster.offset = 3.0;
    for (double &value : raster.values)
        value = (value + 1.0 - 3.0) / 0.5;  // the datum lies a metre lower than the raster's
    BathymetryOptions options;
    options.datumOffsetM = 1.0;
    expectSmallRaster(*read(raster, options).seabed);
    options.datumOffsetM = NaN;
    expectRefusal(refusalOf(raster, options), "datum offset");
}

TEST_F(BathymetryReader, noDataAndWhatIsNoNumberIsUnknown)
{
    TestRaster raster = smallRaster();
    raster.values = {-40, -9999, NaN, -10, INFINITY, -7.3};
    raster.noData = -9999;
    BathymetryOptions options;
    options.noData = -7.3;  // which a float does not hold exactly
    const BathymetryRaster read = this->read(raster, options);
    for (int i = 0; i < 6; ++i)
        EXPECT_EQ(read.seabed->nodeDepth(i % 3, i / 3), i == 0   ? 10.0F
                                                        : i == 3 ? 40.0F
                                                                 : Bathymetry::unknownDepth)
            << i;
    EXPECT_EQ(read.unknown, 4);

    raster.values = {-40, -3.4028234663852886e+38, -60, -10, -20, 5};
    raster.noData = -3.4028234663852886e+38;
    const BathymetryRaster largest = this->read(raster);
    EXPECT_EQ(largest.unknown, 1);
    EXPECT_EQ(largest.land, 1);
}

TEST_F(BathymetryReader, depthsAreRoundedToFloatsTowardsTheSurface)
{
    Random random(3);
    TestRaster raster = smallRaster();
    raster.type = GDT_Float64;
    raster.columns = 40;
    raster.rows = 40;
    raster.values.clear();
    for (int i = 0; i < 1600; ++i)
        raster.values.push_back(-random.real(-10.0, 5000.0));
    const auto seabed = read(raster).seabed;
    for (int i = 0; i < 1600; ++i)
    {
        const double depth = -raster.values[static_cast<std::size_t>((39 - i / 40) * 40 + i % 40)];
        const float held = seabed->nodeDepth(i % 40, i / 40);
        EXPECT_LE(static_cast<double>(held), depth);
        EXPECT_GT(static_cast<double>(std::nextafter(held, 1e9F)), depth);
    }
}

TEST_F(BathymetryReader, degreesBecomeAnAffineImage)
{
    TestRaster raster = smallRaster();
    raster.epsg = 4326;
    raster.transform = {109.0, 0.01, 0.0, 18.5, 0.0, -0.02};
    const BathymetryRaster read = this->read(raster);
    ASSERT_TRUE(read.projection);
    const NodeGrid &grid = read.seabed->grid();
    EXPECT_LT((grid.bounds().min + grid.bounds().max).norm(), 1e-6) << "the origin is the middle of the nodes";
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column)
        {
            const GeoPoint at = GeoPoint::fromLatLon(18.47 + 0.02 * row, 109.005 + 0.01 * column);
            EXPECT_LT((read.projection->forward(at) - grid.node(column, row)).norm(), 1e-6);
        }
    // Degrees to 0 .. 360 east lie where those to 180 do.
    raster.transform = {199.0, 0.01, 0.0, 18.5, 0.0, -0.02};
    const BathymetryRaster pacific = this->read(raster);
    EXPECT_LT(
        (pacific.projection->forward(GeoPoint::fromLatLon(18.47, -160.995)) - pacific.seabed->grid().node(0, 0)).norm(),
        1e-6);
}

TEST_F(BathymetryReader, aWindowIsTheFewestNodesThatEncloseIt)
{
    Random random(4);
    TestRaster raster;
    raster.columns = 30;
    raster.rows = 20;
    raster.transform = {-0.5, 1.0, 0.0, 19.5, 0.0, -1.0};  // nodes at whole numbers
    for (int i = 0; i < 600; ++i)
        raster.values.push_back(-random.real(1.0, 100.0));
    const auto path = write(raster);
    const auto whole = readBathymetry(path).seabed;
    BathymetryOptions options;
    for (const Box &box : {Box{Point(3, 4), Point(9, 8)}, Box{Point(2.6, 3.2), Point(9.4, 8.1)},
                           Box{Point(-50, -50), Point(1, 1)}, Box{Point(-50, -50), Point(50, 50)}})
    {
        options.window = box;
        const auto part = readBathymetry(path, options).seabed;
        const Point low = box.min.array().floor().matrix().cwiseMax(Point(0, 0));
        const Point high = box.max.array().ceil().matrix().cwiseMin(Point(29, 19));
        EXPECT_EQ(part->grid().bounds().min, low);
        EXPECT_EQ(part->grid().bounds().max, high);
        for (std::int64_t row = 0; row < part->grid().rows(); ++row)
            for (std::int64_t column = 0; column < part->grid().columns(); ++column)
                EXPECT_EQ(part->nodeDepth(column, row), whole->nodeDepth(column + static_cast<std::int64_t>(low.x()),
                                                                         row + static_cast<std::int64_t>(low.y())));
    }
    for (const Box &box :
         {Box{Point(40, 4), Point(50, 8)}, Box{Point(9, 8), Point(3, 4)}, Box{Point(3, -9), Point(9, -2)},
          Box{Point(NaN, 4), Point(9, 8)}, Box{Point(3, 4), Point(3, 8)}})
    {
        options.window = box;
        expectRefusal(refusal(path, options), "encloses no cell");
    }
}

TEST_F(BathymetryReader, blocksOfAnyShapeGiveTheSame)
{
    Random random(5);
    TestRaster raster;
    raster.columns = 150;
    raster.rows = 70;
    for (int i = 0; i < raster.columns * raster.rows; ++i)
        raster.values.push_back(random.chance(0.1) ? -9999.0 : -std::floor(random.real(1.0, 100.0)));
    raster.noData = -9999;
    const auto strips = read(raster).seabed;
    for (const std::vector<std::string> &creation :
         {std::vector<std::string>{"TILED=YES", "BLOCKXSIZE=64", "BLOCKYSIZE=16"},
          std::vector<std::string>{"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=64", "COMPRESS=DEFLATE"},
          std::vector<std::string>{"BLOCKYSIZE=70"}, std::vector<std::string>{"BLOCKYSIZE=1"}})
    {
        raster.creation = creation;
        const auto path = write(raster);
        const auto seabed = readBathymetry(path).seabed;
        BathymetryOptions options;
        options.window = Box{Point(20.5, -60.5), Point(110.5, -9.5)};
        const auto part = readBathymetry(path, options).seabed;
        for (std::int64_t row = 0; row < 70; ++row)
            for (std::int64_t column = 0; column < 150; ++column)
            {
                ASSERT_EQ(seabed->nodeDepth(column, row), strips->nodeDepth(column, row)) << creation.front();
                const std::int64_t i = column - 20;
                const std::int64_t j = row - 9;
                if (i >= 0 && j >= 0 && i < part->grid().columns() && j < part->grid().rows())
                {
                    ASSERT_EQ(part->nodeDepth(i, j), strips->nodeDepth(column, row)) << creation.front();
                }
            }
    }
}

TEST_F(BathymetryReader, refusesInOneSentence)
{
    const TestRaster good = smallRaster();
    const auto with = [&good](auto &&change)
    {
        TestRaster raster = good;
        change(raster);
        return raster;
    };
    using R = TestRaster;
    expectRefusal(refusalOf(with([](R &r) { r.values.assign(6, NaN); })), "none of its 6 nodes has a value");
    expectRefusal(refusalOf(with([](R &r) { r.values.assign(6, -9.0), r.noData = -9.0; })), "has a value");
    expectRefusal(refusalOf(with([](R &r) { r.values = {4, 5, 6, 7, 8, 9}; })),
                  "none of its nodes is under water: the deepest lies 4.000000 m above");
    expectRefusal(refusalOf(with([](R &r) { r.values[2] = -32768; })), "value -32768.000000 at column 2, row 0");
    expectRefusal(refusalOf(with([](R &r) { r.transform = {0, 1, 0.1, 0, 0, -1}; })), "rotated");
    expectRefusal(refusalOf(with([](R &r) { r.transform = {0, 1, 0, 0, 0.1, -1}; })), "rotated");
    expectRefusal(refusalOf(with([](R &r) { r.transform = {0, -1, 0, 0, 0, -1}; })), "west to east");
    expectRefusal(refusalOf(with([](R &r) { r.transform = {NaN, 1, 0, 0, 0, -1}; })), "pixels");
    expectRefusal(refusalOf(with([](R &r) { r.transform.reset(); })), "no geotransform");
    expectRefusal(refusalOf(with([](R &r) { r.epsg = 0; })), "no coordinate system");
    expectRefusal(refusalOf(with([](R &r) { r.epsg = 4326, r.transform = {0, 1, 0, 90.6, 0, -1}; })), "beyond a pole");
    expectRefusal(refusalOf(with([](R &r) { r.epsg = 4978; })), "neither of a plane nor of degrees");
    expectRefusal(refusalOf(with([](R &r) { r.unit = "ft"; })), "its unit is 'ft'");
    expectRefusal(refusalOf(with([](R &r) { r.type = GDT_CFloat32; })), "complex");
    expectRefusal(refusalOf(with([](R &r) { r.type = GDT_Byte, r.palette = true; })), "picture (Palette)");
    expectRefusal(refusalOf(with([](R &r) { r.columns = 6, r.rows = 1; })), "6 x 1 pixels");
    expectRefusal(refusalOf(with([](R &r) { r.scale = 0.0, r.offset = 1.0; })), "scale 0");
    BathymetryOptions options;
    options.band = 2;
    expectRefusal(refusalOf(good, options), "no such band");
    options = {};
    options.mostNodes = 5;
    expectRefusal(refusalOf(good, options), "3 x 2 nodes are more than the 5 allowed; give a window");
    options = {};
    options.coordinates = RasterCoordinates::Metres;
    TestRaster nowhere = good;
    nowhere.epsg = 0;
    expectSmallRaster(*read(nowhere, options).seabed);
}

TEST_F(BathymetryReader, refusesFilesThatAreNoRasters)
{
    expectRefusal(refusal(folder / "missing.tif"), "is no raster that can be read");
    writeBytes(folder / "text.tif", "twenty fathoms and a sandy bottom");
    expectRefusal(refusal(folder / "text.tif"), "text.tif is no raster");
    writeBytes(folder / "empty.nc", "");
    expectRefusal(refusal(folder / "empty.nc"), "empty.nc is no raster");

    TestRaster raster;
    raster.columns = raster.rows = 200;
    raster.values.assign(40000, -7.0);
    const auto path = write(raster);
    const std::string bytes = readBytes(path);
    writeBytes(folder / "cut.tif", bytes.substr(0, bytes.size() / 2));
    expectRefusal(refusal(folder / "cut.tif"), "cut.tif");
}

/// Highest resident memory of this process so far, bytes.
double peakBytes()
{
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "VmHWM:")
        {
            double kilobytes = 0.0;
            status >> kilobytes;
            return 1024.0 * kilobytes;
        }
    return 0.0;
}

TEST_F(BathymetryReader, aHundredMillionNodesFitIntoAGigabyte)
{
    TestRaster raster;
    raster.columns = raster.rows = 10000;
    raster.noData = NaN;
    raster.type = GDT_Float64;  // 800 MB if GDAL kept them
    raster.creation = {"TILED=YES", "SPARSE_OK=TRUE"};
    raster.values.clear();
    const auto path = write(raster);
    {
        // One block is all that the sparse file holds.
        GDALDatasetH dataset = GDALOpen(path.c_str(), GA_Update);
        std::vector<float> block(256 * 256, -25.0F);
        ASSERT_EQ(GDALRasterIO(GDALGetRasterBand(dataset, 1), GF_Write, 5120, 5120, 256, 256, block.data(), 256, 256,
                               GDT_Float32, 0, 0),
                  CE_None);
        GDALClose(dataset);
    }
    const BathymetryRaster read = readBathymetry(path);
    EXPECT_EQ(read.seabed->grid().nodeCount(), 100000000);
    EXPECT_EQ(read.unknown, 100000000 - 256 * 256);
    EXPECT_LT(read.seabed->byteCount(), 400001000u);
    EXPECT_EQ(read.seabed->depthAt(Point(5200.5, -5200.5)), 25.0);
    EXPECT_LT(peakBytes(), 1e9);
}

/// Every node against the file as GDAL gives it, and random places against bilinear values of the raster.
void expectEqualsFile(const std::filesystem::path &path, const BathymetryOptions &options, double sign)
{
    const BathymetryRaster read = readBathymetry(path, options);
    const PlainRaster plain(path);
    const NodeGrid &grid = read.seabed->grid();
    ASSERT_EQ(grid.columns(), plain.columns);
    ASSERT_EQ(grid.rows(), plain.rows);
    ASSERT_TRUE(read.projection);
    for (int row = 0; row < plain.rows; ++row)
        for (int column = 0; column < plain.columns; ++column)
        {
            const bool northUp = plain.transform[5] < 0.0;
            const auto depth = static_cast<float>(sign * plain.at(column, northUp ? plain.rows - 1 - row : row));
            ASSERT_EQ(read.seabed->nodeDepth(column, row), std::isfinite(depth) ? depth : Bathymetry::unknownDepth);
        }
    Random random(6);
    for (int i = 0; i < 2000; ++i)
    {
        const Point p = random.pointIn(grid.bounds());
        const GeoPoint at = read.projection->inverse(p);
        const double depth = read.seabed->depthAt(p);
        if (std::isfinite(depth))
        {
            ASSERT_NEAR(depth, sign * plain.bilinear(at.longitudeDeg(), at.latitudeDeg()), 1e-4);
        }
    }
}

TEST(RealBathymetry, equalsTheFilesNodeByNodeAndBetween)
{
    SEAHEX_TEST_DATA_OR_SKIP(folder, "bathymetry");
    BathymetryOptions options;
    for (const char *name :
         {"52north_tests_depth_data.nc", "gmt_Iceland.nc", "etopo5_gd_shangchuan.tif", "etopo5_hn_sanya.tif"})
    {
        SCOPED_TRACE(name);
        expectEqualsFile(folder / name, options, -1.0);
    }
    expectRefusal(refusal(folder / "geoclaw_kahului_1s.asc"), "no coordinate system");
    options.coordinates = RasterCoordinates::Degrees;
    expectEqualsFile(folder / "geoclaw_kahului_1s.asc", options, -1.0);
}

}  // namespace
