#include "seahex/io/Picture.h"

#include "seahex/io/PictureFrame.h"
#include "seahex/io/PicturePalette.h"

#include <gdal.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>

// Asked by the leak checker of a sanitized build. fontconfig, below cairo, links its patterns by offsets instead of
// pointers, so that its cache looks lost.
extern "C" const char *__lsan_default_suppressions()  // NOLINT(bugprone-reserved-identifier)
{
    return "leak:libfontconfig";
}

namespace seahex
{

namespace
{

namespace fs = std::filesystem;

using Rgb = std::array<int, 3>;

Rgb rgb(const Colour &colour)
{
    const auto byte = [](double component)
    {
        return static_cast<int>(std::lround(255.0 * component));
    };
    return {byte(colour.red), byte(colour.green), byte(colour.blue)};
}

testing::AssertionResult isNear(const Rgb &found, const Colour &expected, int tolerance = 3)
{
    const Rgb e = rgb(expected);
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(found[i] - e[i]) > tolerance)
            return testing::AssertionFailure()
                   << testing::PrintToString(found) << " instead of " << testing::PrintToString(e);
    return testing::AssertionSuccess();
}

/// A picture read back, by a reader that knows nothing of cairo.
class Image
{
public:
    explicit Image(const std::string &path)
    {
        GDALAllRegister();
        GDALDatasetH file = GDALOpen(path.c_str(), GA_ReadOnly);
        if (file == nullptr)
            throw std::runtime_error("can't read " + path);
        width_ = GDALGetRasterXSize(file);
        height_ = GDALGetRasterYSize(file);
        for (std::size_t i = 0; i < 3; ++i)
        {
            bands_[i].resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
            if (GDALRasterIO(GDALGetRasterBand(file, static_cast<int>(i) + 1), GF_Read, 0, 0, width_, height_,
                             bands_[i].data(), width_, height_, GDT_Byte, 0, 0) != CE_None)
                throw std::runtime_error("can't read the pixels of " + path);
        }
        GDALClose(file);
    }

    int width() const { return width_; }
    int height() const { return height_; }

    Rgb at(int x, int y) const
    {
        const std::size_t i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
        return {bands_[0][i], bands_[1][i], bands_[2][i]};
    }
    Rgb at(const Point &page) const
    {
        return at(static_cast<int>(std::floor(page.x())), static_cast<int>(std::floor(page.y())));
    }

    /// The colour of most pixels around a place, whatever thin lines cross it.
    Rgb around(const Point &page, int reach) const
    {
        std::map<Rgb, int> votes;
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx)
                ++votes[at(page + Point(dx, dy))];
        const auto most = std::max_element(votes.begin(), votes.end(),
                                           [](const auto &a, const auto &b) { return a.second < b.second; });
        return most->first;
    }

private:
    int width_ = 0;
    int height_ = 0;
    std::array<std::vector<unsigned char>, 3> bands_;
};

std::string contentsOf(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::shared_ptr<const HexOccupancy> occupancyOf(const HexLattice &lattice, const std::vector<OffsetCoord> &blocked)
{
    const CellLayout layout(lattice.columns(), lattice.rows());
    std::vector<std::uint64_t> words(layout.wordCount(), ~std::uint64_t{0});
    const auto bit = [](CellIndex i)
    {
        return std::uint64_t{1} << (i & 63);
    };
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < lattice.columns(); ++column)
        {
            const CellIndex i = layout.index(OffsetCoord{column, row});
            words[i >> 6] &= ~bit(i);
        }
    for (const OffsetCoord cell : blocked)
        words[layout.index(cell) >> 6] |= bit(layout.index(cell));
    return std::make_shared<const HexOccupancy>(lattice, layout, std::move(words));
}

Shape rectangle(const Point &min, const Point &max)
{
    Polygon area;
    area.outer() = {min, {max.x(), min.y()}, max, {min.x(), max.y()}, min};
    Shape shape;
    shape.areas.push_back(area);
    return shape;
}

const Projection &metricFrame()
{
    static const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(60.0, 5.0));
    return projection;
}

class Picture : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto *test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) /
                  (std::string("seahex_picture_") + test->name() + std::to_string(std::random_device{}()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string path(const std::string &name) const { return (folder_ / name).string(); }

    std::vector<std::string> files() const
    {
        std::vector<std::string> names;
        for (const auto &entry : fs::directory_iterator(folder_))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

    /// What writePicture says went wrong, or "" if nothing did.
    std::string complaint(const std::string &file, const PictureContent &content) const
    {
        try
        {
            writePicture(path(file), content);
        }
        catch (const PictureError &error)
        {
            return error.what();
        }
        return "";
    }

    fs::path folder_;
};

// 12 x 10 cells of 100 m: one blocked in open water, land in the south-east, a shoal in the south-west.
struct SmallWorld
{
    HexLattice lattice{{-600.0, 500.0}, 100.0, 12, 10};
    OffsetCoord lonely{3, 3};
    OffsetCoord ashore{9, 7};
    OffsetCoord overShoal{2, 7};
    OffsetCoord open{6, 1};
    Shape land = rectangle(at(ashore) - Point(120, 120), at(ashore) + Point(120, 120));
    Shape shoal = rectangle(at(overShoal) - Point(120, 120), at(overShoal) + Point(120, 120));

    Point at(OffsetCoord cell) const { return lattice.centre(toCube(cell)); }

    PictureContent content(const Projection &projection = metricFrame()) const
    {
        PictureContent content{projection, occupancyOf(lattice, {lonely, ashore})};
        content.land = {&land};
        content.shoals = {&shoal};
        return content;
    }
};

}  // namespace

TEST_F(Picture, PngShowsWaterShoalLandAndBlockedCellsInTheirColours)
{
    const SmallWorld world;
    const PictureContent content = world.content();
    writePicture(path("world.png"), content);

    EXPECT_EQ(contentsOf(path("world.png")).substr(0, 8), "\x89PNG\r\n\x1a\n");
    const Image image(path("world.png"));
    const PictureFrame frame = pictureFrame(content);
    EXPECT_EQ(image.width(), 1600);
    EXPECT_EQ(image.height(), frame.heightPx);
    const auto colourAt = [&](OffsetCoord cell)
    {
        return image.around(frame.toPage(world.at(cell)), 10);
    };
    EXPECT_TRUE(isNear(colourAt(world.open), palette::water));
    EXPECT_TRUE(isNear(colourAt(world.overShoal), palette::shoal));
    EXPECT_TRUE(isNear(colourAt(world.ashore), palette::land));
    EXPECT_TRUE(isNear(colourAt(world.lonely), blend(palette::water, palette::blocked, palette::blockedOpacity)));
}

TEST_F(Picture, ExpandedCellsAreShadedFromFirstToLast)
{
    const SmallWorld world;
    PictureContent content = world.content();
    const CellLayout &layout = content.occupancy->layout();
    const std::vector<OffsetCoord> order{{1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}, {1, 0}, {6, 1}};
    for (const OffsetCoord cell : order)
        content.expanded.push_back(layout.index(cell));
    content.expanded.insert(content.expanded.begin(), layout.index(OffsetCoord{-1, -1}));  // not of the lattice
    writePicture(path("world.png"), content);

    const Image image(path("world.png"));
    const PictureFrame frame = pictureFrame(content);
    const auto colourAt = [&](OffsetCoord cell)
    {
        return image.around(frame.toPage(world.at(cell)), 10);
    };
    constexpr int oneShade = 16;
    EXPECT_TRUE(isNear(colourAt({1, 0}), expansionColour(1.0 / 7.0), oneShade)) << "named twice: the first time counts";
    EXPECT_TRUE(isNear(colourAt({4, 0}), expansionColour(4.0 / 7.0), oneShade));
    EXPECT_TRUE(isNear(colourAt({6, 1}), expansionColour(1.0), oneShade));
    EXPECT_TRUE(isNear(colourAt({8, 2}), palette::water));
}

TEST_F(Picture, RouteAndRawPathHaveColoursOfTheirOwn)
{
    const SmallWorld world;
    PictureContent content = world.content();
    content.route = {world.at({0, 1}), world.at({11, 1})};
    content.rawPath = {world.at({0, 9}), world.at({11, 9})};
    content.start = content.route.front();
    content.goal = content.route.back();
    content.title = "A route\nof some metres";
    content.footer = "Not for navigation.";
    writePicture(path("world.png"), content);

    const Image image(path("world.png"));
    const PictureFrame frame = pictureFrame(content);
    const auto middle = [](const LineString &line)
    {
        return Point(0.5 * (line.front() + line.back()) + Point(17, 0));
    };
    EXPECT_TRUE(isNear(image.at(frame.toPage(middle(content.route))), palette::route));
    const Point raw = frame.toPage(middle(content.rawPath));
    const auto dark = [](const Rgb &c)
    {
        return c[0] + c[1] + c[2] < 300;
    };
    EXPECT_TRUE(dark(image.at(raw)) || dark(image.at(Point(raw - Point(0, 1)))));
    EXPECT_TRUE(isNear(image.at(Point(frame.toPage(*content.start))), palette::ink));
}

// Cells drawn as outlines say what the occupancy says.
RC_GTEST_PROP(PictureOfCells, ShowsBlockedWhatIsBlocked, ())
{
    const auto columns = *rc::gen::inRange<std::int64_t>(1, 30);
    const auto rows = *rc::gen::inRange<std::int64_t>(1, 30);
    const HexLattice lattice({-300.0, 200.0}, 20.0, columns, rows);
    std::vector<OffsetCoord> blocked;
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t column = 0; column < columns; ++column)
            if (*rc::gen::inRange(0, 3) == 0)
                blocked.push_back({column, row});
    PictureContent content{metricFrame(), occupancyOf(lattice, blocked)};
    content.widthPx = 800;
    const std::string file = testing::TempDir() + "/seahex_cells_" + std::to_string(std::random_device{}()) + ".png";
    writePicture(file, content);
    const Image image(file);
    fs::remove(file);

    const PictureFrame frame = pictureFrame(content);
    const Colour tint = blend(palette::water, palette::blocked, palette::blockedOpacity);
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t column = 0; column < columns; ++column)
        {
            const HexCoord cell = toCube(OffsetCoord{column, row});
            const Rgb found = image.around(frame.toPage(lattice.centre(cell)), 3);
            RC_ASSERT(bool(isNear(found, content.occupancy->isBlocked(cell) ? tint : palette::water)));
        }
}

// Cells painted as an image say the same, here of about 5 x 5 pixels each.
TEST_F(Picture, ImageShowsEveryCellOfALargeLattice)
{
    const HexLattice lattice({-3000.0, 2000.0}, 20.0, 300, 260);
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::vector<OffsetCoord> blocked;
    PictureContent content{metricFrame(), nullptr};
    const CellLayout layout(lattice.columns(), lattice.rows());
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < lattice.columns(); ++column)
        {
            if (random() % 3 == 0)
                blocked.push_back({column, row});
            else if (column >= 150)
                content.expanded.push_back(layout.index(OffsetCoord{column, row}));
        }
    content.occupancy = occupancyOf(lattice, blocked);
    const auto isOpen = [&](const Rgb &c)
    {
        return isNear(c, palette::water);
    };
    const PictureFrame frame = pictureFrame(content);
    ASSERT_GT(lattice.pitch() * frame.pxPerUnitX, 4.0);
    writePicture(path("cells.png"), content);
    const Image image(path("cells.png"));
    // Four pixels around each cell's centre: even two crossing lines of the graticule leave one of them free.
    const auto shows = [&](HexCoord cell, const auto &test)
    {
        const Point page = frame.toPage(lattice.centre(cell));
        const std::array<Point, 4> around{{{-1.2, -1.0}, {1.2, -1.0}, {-1.2, 1.0}, {1.2, 1.0}}};
        return std::any_of(around.begin(), around.end(),
                           [&](const Point &aside) { return test(image.at(Point(page + aside))); });
    };
    for (const OffsetCoord cell : blocked)
        EXPECT_TRUE(shows(toCube(cell), [&](const Rgb &c) { return c[0] > c[1] + 15; }))
            << cell.column << " " << cell.row;
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < 150; ++column)
        {
            const HexCoord cell = toCube(OffsetCoord{column, row});
            EXPECT_TRUE(content.occupancy->isBlocked(cell) || shows(cell, isOpen)) << column << " " << row;
        }
    const double last = static_cast<double>(content.expanded.size() - 1);
    for (std::size_t i = 0; i < content.expanded.size(); i += 97)
        EXPECT_TRUE(shows(layout.cell(content.expanded[i]),
                          [&](const Rgb &c) { return isNear(c, expansionColour(static_cast<double>(i) / last), 4); }));
}

TEST_F(Picture, NoSingleBlockedCellAmongFourMillionVanishes)
{
    const HexLattice lattice({-50000.0, 45000.0}, 50.0, 2000, 2100);
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::vector<OffsetCoord> blocked;
    blocked.reserve(200);
    // Not at the edge, where pixels are tinted anyway: what is outside is blocked.
    for (int i = 0; i < 200; ++i)
        blocked.push_back(
            {static_cast<std::int64_t>(5 + random() % 1990), static_cast<std::int64_t>(5 + random() % 2090)});

    const PictureContent free{metricFrame(), occupancyOf(lattice, {})};
    const PictureContent dotted{metricFrame(), occupancyOf(lattice, blocked)};
    writePicture(path("free.png"), free);
    writePicture(path("dotted.png"), dotted);
    const Image without(path("free.png"));
    const Image with(path("dotted.png"));
    const PictureFrame frame = pictureFrame(dotted);
    ASSERT_LT(lattice.pitch() * frame.pxPerUnitX, 1.0) << "cells should be smaller than a pixel here";
    for (const OffsetCoord cell : blocked)
    {
        const Point page = frame.toPage(lattice.centre(toCube(cell)));
        const Rgb before = without.at(page);
        const Rgb after = with.at(page);
        EXPECT_GT(before[1] - after[1], 40) << "cell " << cell.column << ", " << cell.row;
    }
    const Rgb aside = with.at(frame.toPage(lattice.centre(toCube(OffsetCoord{-1, 5}))) + Point(20.5, 0.5));
    EXPECT_TRUE(isNear(aside, palette::water)) << "free water stays free";
}

TEST_F(Picture, SvgHoldsOutlinesForFewCellsAndAnImageForMany)
{
    const SmallWorld world;
    writePicture(path("few.svg"), world.content());
    const std::string few = contentsOf(path("few.svg"));
    EXPECT_EQ(few.substr(0, 5), "<?xml");
    EXPECT_NE(few.find("width=\"1600px\""), std::string::npos) << few.substr(0, 300);
    EXPECT_NE(few.find("</svg>"), std::string::npos);
    EXPECT_EQ(few.find("<image"), std::string::npos);

    const HexLattice large({-50000.0, 45000.0}, 50.0, 2000, 2100);
    PictureContent content{metricFrame(), occupancyOf(large, {{1000, 1000}})};
    writePicture(path("many.svg"), content);
    EXPECT_NE(contentsOf(path("many.svg")).find("<image"), std::string::npos);

    const Point middle = large.centre(toCube(OffsetCoord{1000, 1000}));
    content.crop = Box{middle - Point(2000, 2000), middle + Point(2000, 2000)};
    writePicture(path("part.svg"), content);
    EXPECT_EQ(contentsOf(path("part.svg")).find("<image"), std::string::npos) << "few of the many are in view";
}

TEST_F(Picture, SvgOfThePublishedSizeStaysSmallThoughEverythingIsExpandedOrRagged)
{
    const HexLattice lattice({112.45, 22.05}, 0.0042, 143, 159);
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::vector<OffsetCoord> blocked;
    PictureContent content{Projection::plateCarree(), nullptr};
    const CellLayout layout(143, 159);
    for (std::int64_t row = 0; row < 159; ++row)
        for (std::int64_t column = 0; column < 143; ++column)
        {
            if (column < 40 && random() % 2 == 0)
                blocked.push_back({column, row});
            else
                content.expanded.push_back(layout.index(OffsetCoord{column, row}));
        }
    const HexCoord from = toCube(OffsetCoord{20, 20});
    std::stable_sort(content.expanded.begin(), content.expanded.end(),
                     [&](CellIndex a, CellIndex b)
                     { return hexDistance(from, layout.cell(a)) < hexDistance(from, layout.cell(b)); });
    content.occupancy = occupancyOf(lattice, blocked);
    writePicture(path("published.svg"), content);
    EXPECT_LT(fs::file_size(path("published.svg")), 3'000'000u);
}

TEST_F(Picture, LandFarLargerThanTheViewFillsItWhole)
{
    const SmallWorld world;
    PictureContent content = world.content();
    const Shape continent = rectangle({-9e9, -9e9}, {9e9, 9e9});
    content.land = {&continent};
    const Point middle = world.at({6, 5});
    content.crop = Box{middle - Point(0.5, 0.5), middle + Point(0.5, 0.5)};
    writePicture(path("world.png"), content);
    const Image image(path("world.png"));
    const PictureFrame frame = pictureFrame(content);
    for (const double x : {0.1, 0.9})
        for (const double y : {0.1, 0.9})
            EXPECT_TRUE(
                isNear(image.around(frame.map.min + (frame.map.max - frame.map.min).cwiseProduct(Point(x, y)), 4),
                       palette::land));
}

TEST_F(Picture, ReplacesAnOlderFileAndLeavesNoOther)
{
    const SmallWorld world;
    std::ofstream(path("world.png")) << "old";
    writePicture(path("world.png"), world.content());
    writePicture(path("world.SVG"), world.content());
    EXPECT_EQ(contentsOf(path("world.png")).substr(1, 3), "PNG");
    EXPECT_EQ(files(), (std::vector<std::string>{"world.SVG", "world.png"}));
}

TEST_F(Picture, RefusesOtherExtensionsByName)
{
    const SmallWorld world;
    const PictureContent content = world.content();
    EXPECT_NE(complaint("world.pdf", content).find("world.pdf must end in .svg or .png, not in .pdf"),
              std::string::npos);
    EXPECT_NE(complaint("world", content).find("must end in .svg or .png"), std::string::npos);
    EXPECT_TRUE(files().empty());
}

TEST_F(Picture, RefusesAPlaceThatCannotBeWrittenAndLeavesNothing)
{
    const SmallWorld world;
    const PictureContent content = world.content();
    EXPECT_NE(complaint("nowhere/world.png", content).find("nowhere/world.png: No such file"), std::string::npos);
    fs::create_directories(folder_ / "taken.svg" / "inside");
    EXPECT_NE(complaint("taken.svg", content).find("can't write the picture"), std::string::npos);
    EXPECT_EQ(files(), std::vector<std::string>{"taken.svg"});
    EXPECT_TRUE(fs::exists(folder_ / "taken.svg" / "inside"));
}

TEST_F(Picture, RefusesContentThatCannotBeDrawn)
{
    const SmallWorld world;
    PictureContent none{metricFrame(), nullptr};
    EXPECT_NE(complaint("a.png", none).find("occupancy"), std::string::npos);
    PictureContent flat = world.content();
    flat.crop = Box{{0.0, 0.0}, {100.0, 0.0}};
    EXPECT_NE(complaint("a.png", flat).find("no extent"), std::string::npos);
    flat.crop = Box{{0.0, 0.0}, {std::nan(""), 1.0}};
    EXPECT_NE(complaint("a.png", flat).find("no extent"), std::string::npos);
    PictureContent narrow = world.content();
    narrow.widthPx = 399;
    EXPECT_NE(complaint("a.png", narrow).find("399 pixels"), std::string::npos);
    EXPECT_TRUE(files().empty());
}

TEST_F(Picture, PointsThatAreNoNumbersAreLeftOut)
{
    const SmallWorld world;
    PictureContent content = world.content();
    const double nan = std::nan("");
    content.route = {world.at({0, 1}), {nan, 0.0}, world.at({11, 1})};
    content.start = Point(nan, nan);
    content.goal = Point(0.0, 1e300);
    Shape broken;
    broken.points = {{nan, 1.0}, {1e300, 1e300}};
    broken.lines = {LineString{{nan, nan}, {1.0, nan}}};
    content.dangers = {&broken};
    EXPECT_EQ(complaint("a.png", content), "");
}

}  // namespace seahex
