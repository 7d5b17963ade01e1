#include "seahex/io/Picture.h"

#include "io/PictureProbe.h"

#include <cmath>
#include <filesystem>
#include <fstream>

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

using namespace test;

Shape rectangle(const Point &min, const Point &max)
{
    Polygon area;
    area.outer() = {min, {max.x(), min.y()}, max, {min.x(), max.y()}, min};
    Shape shape;
    shape.areas.push_back(area);
    return shape;
}

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

TEST_F(Picture, LegendNamesThePathsAsTheCallerDoesAndALongNameKeepsToItsRoom)
{
    const SmallWorld world;
    PictureContent content = world.content();
    content.route = {world.at({0, 1}), world.at({11, 1})};
    content.rawPath = {world.at({0, 9}), world.at({11, 9})};
    content.widthPx = 800;
    const auto drawn = [&](const std::string &route, const std::string &rawPath)
    {
        content.routeName = route;
        content.rawPathName = rawPath;
        writePicture(path("names.png"), content);
        return Image(path("names.png"));
    };
    const auto columnsThatDiffer = [&](const Image &one, const Image &other)
    {
        std::vector<int> columns;
        for (int x = 0; x < one.width(); ++x)
            for (int y = 0; y < one.height(); ++y)
                if (one.at(x, y) != other.at(x, y))
                {
                    EXPECT_GT(y, pictureFrame(content).legendTop) << "names stand in the legend";
                    columns.push_back(x);
                    break;
                }
        return columns;
    };
    constexpr int sample = 22;  // left of a name
    for (const std::size_t length : {4U, 40U, 90U})
    {
        const std::string name(length, 'w');
        const Image image = drawn(name, "B");
        const std::vector<int> first = columnsThatDiffer(image, drawn(std::string(length, 'm'), "B"));
        const std::vector<int> second = columnsThatDiffer(image, drawn(name, "C"));
        ASSERT_FALSE(first.empty());
        ASSERT_FALSE(second.empty());
        EXPECT_LT(first.back(), second.front() - sample) << length;
        EXPECT_GE(first.back() - first.front(), std::min<int>(100, 3 * static_cast<int>(length)) - 5) << length;
    }
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
