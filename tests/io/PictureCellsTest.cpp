#include "seahex/io/Picture.h"

#include "io/PictureProbe.h"
#include "support/TestCharts.h"

#include <rapidcheck/gtest.h>

#include <random>
#include <set>
#include <sstream>

namespace seahex
{

namespace
{

using namespace test;

enum class Cells
{
    Hexagons,
    Squares
};

Lattice latticeOf(Cells kind, const Point &northWest, double pitch, std::int64_t columns, std::int64_t rows)
{
    if (kind == Cells::Squares)
        return SquareLattice(northWest, pitch, columns, rows);
    return HexLattice(northWest, pitch, columns, rows);
}

class PictureOfEitherLattice : public Picture, public testing::WithParamInterface<Cells>
{
protected:
    static Lattice latticeOf(const Point &northWest, double pitch, std::int64_t columns, std::int64_t rows)
    {
        return seahex::latticeOf(GetParam(), northWest, pitch, columns, rows);
    }
};

std::vector<OffsetCoord> randomCells(const Lattice &lattice, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<OffsetCoord> cells;
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < lattice.columns(); ++column)
            if (random() % 3 == 0)
                cells.push_back({column, row});
    return cells;
}

/// The cells that lie closer to a point than `reach`, first the one that holds it.
std::vector<OffsetCoord> cellsNear(const Lattice &lattice, const Point &p, double reach)
{
    std::vector<OffsetCoord> cells{lattice.cellAt(p)};
    for (const OffsetCoord neighbour : lattice.neighbours(cells.front()))
        if (lattice.distance(p, neighbour) < reach)
            cells.push_back(neighbour);
    return cells;
}

/// True if cells with one state hold the point and all that is within reach of it.
bool isSure(const Occupancy &occupancy, const Point &p, double reach)
{
    const std::vector<OffsetCoord> cells = cellsNear(occupancy.lattice(), p, reach);
    return std::all_of(cells.begin(), cells.end(),
                       [&](OffsetCoord cell)
                       { return occupancy.isBlocked(cell) == occupancy.isBlocked(cells.front()); });
}

/// True for the tint of blocked cells and their edges, whatever thin dark line crosses them.
bool isTinted(const Rgb &c)
{
    return c[0] > c[1] + 6;
}

/// Calls visit(x, y, point of the plane) for the pixels of the map that lie within the lattice's bounds.
template <class Visit>
void forEachPixel(const PictureFrame &frame, const Lattice &lattice, Visit &&visit)
{
    const double pixel = 1.0 / frame.pxPerUnitX;
    const Box bounds = lattice.bounds();
    const Box inner{bounds.min + Point::Constant(1.5 * pixel), bounds.max - Point::Constant(1.5 * pixel)};
    for (int y = static_cast<int>(frame.map.min.y()) + 2; y < static_cast<int>(frame.map.max.y()) - 2; ++y)
        for (int x = static_cast<int>(frame.map.min.x()) + 2; x < static_cast<int>(frame.map.max.x()) - 2; ++x)
        {
            const Point p = frame.toPlane({x + 0.5, y + 0.5});
            if (inner.contains(p))
                visit(x, y, p);
        }
}

/// The closed loops of the tinted area in an SVG, in page coordinates: of the paths filled and stroked with its colour.
std::vector<std::vector<Point>> tintedLoops(const std::string &svg)
{
    std::vector<std::vector<Point>> loops;
    for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1))
    {
        const std::size_t data = svg.find(" d=\"", at) + 4;
        std::string look = svg.substr(at, data - at);
        look.erase(std::remove(look.begin(), look.end(), ' '), look.end());
        const std::string colour = "rgb(55%,16%,20%)";
        if (look.find(colour) == look.rfind(colour))
            continue;
        std::istringstream words(svg.substr(data, svg.find('"', data) - data));
        for (std::string word; words >> word;)
        {
            if (word == "M")
                loops.emplace_back();
            if (word != "M" && word != "L")
                continue;
            double x = 0.0;
            double y = 0.0;
            words >> x >> y;
            loops.back().emplace_back(x, y);
        }
    }
    const auto isNone = [](const std::vector<Point> &loop)
    {
        return loop.size() < 3;
    };
    loops.erase(std::remove_if(loops.begin(), loops.end(), isNone), loops.end());
    return loops;
}

double signedArea(const std::vector<Point> &loop)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
        const Point &a = loop[i];
        const Point &b = loop[(i + 1) % loop.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return 0.5 * twice;
}

}  // namespace

// Cells drawn as outlines say what the occupancy says.
RC_GTEST_PROP(PictureOfCells, ShowsBlockedWhatIsBlocked, ())
{
    const auto columns = *rc::gen::inRange<std::int64_t>(1, 30);
    const auto rows = *rc::gen::inRange<std::int64_t>(1, 30);
    const auto kind = *rc::gen::element(Cells::Hexagons, Cells::Squares);
    const Lattice lattice = latticeOf(kind, {-300.0, 200.0}, 20.0, columns, rows);
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
    std::filesystem::remove(file);

    const PictureFrame frame = pictureFrame(content);
    const Colour tint = blend(palette::water, palette::blocked, palette::blockedOpacity);
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t column = 0; column < columns; ++column)
        {
            const OffsetCoord cell{column, row};
            const Rgb found = image.around(frame.toPage(lattice.centre(cell)), 3);
            RC_ASSERT(bool(isNear(found, content.occupancy->isBlocked(cell) ? tint : palette::water)));
        }
}

// Cells painted as an image say the same, here of about 5 x 5 pixels each.
TEST_P(PictureOfEitherLattice, ImageShowsEveryCellOfALargeLattice)
{
    const Lattice lattice = latticeOf({-3000.0, 2000.0}, 20.0, 300, 260);
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
    const auto shows = [&](OffsetCoord cell, const auto &test)
    {
        const Point page = frame.toPage(lattice.centre(cell));
        const std::array<Point, 4> around{{{-1.2, -1.0}, {1.2, -1.0}, {-1.2, 1.0}, {1.2, 1.0}}};
        return std::any_of(around.begin(), around.end(),
                           [&](const Point &aside) { return test(image.at(Point(page + aside))); });
    };
    for (const OffsetCoord cell : blocked)
        EXPECT_TRUE(shows(cell, [&](const Rgb &c) { return c[0] > c[1] + 15; })) << cell.column << " " << cell.row;
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < 150; ++column)
        {
            const OffsetCoord cell{column, row};
            EXPECT_TRUE(content.occupancy->isBlocked(cell) || shows(cell, isOpen)) << column << " " << row;
        }
    const double last = static_cast<double>(content.expanded.size() - 1);
    for (std::size_t i = 0; i < content.expanded.size(); i += 97)
        EXPECT_TRUE(shows(layout.offset(content.expanded[i]),
                          [&](const Rgb &c) { return isNear(c, expansionColour(static_cast<double>(i) / last), 4); }));
}

TEST_P(PictureOfEitherLattice, NoSingleBlockedCellAmongFourMillionVanishes)
{
    const Lattice lattice = latticeOf({-50000.0, 45000.0}, 50.0, 2000, 2100);
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
        const Point page = frame.toPage(lattice.centre(cell));
        const Rgb before = without.at(page);
        const Rgb after = with.at(page);
        EXPECT_GT(before[1] - after[1], 40) << "cell " << cell.column << ", " << cell.row;
    }
    const Rgb aside = with.at(frame.toPage(lattice.centre({-1, 5})) + Point(20.5, 0.5));
    EXPECT_TRUE(isNear(aside, palette::water)) << "free water stays free";
}

TEST_P(PictureOfEitherLattice, SvgOfThePublishedSizeStaysSmallThoughEverythingIsExpandedOrRagged)
{
    const Lattice lattice = latticeOf({112.45, 22.05}, 0.0042, 143, 159);
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
    const Point from = lattice.centre({20, 20});
    const auto distance = [&](CellIndex cell)
    {
        return (lattice.centre(layout.offset(cell)) - from).norm();
    };
    std::stable_sort(content.expanded.begin(), content.expanded.end(),
                     [&](CellIndex a, CellIndex b) { return distance(a) < distance(b); });
    content.occupancy = occupancyOf(lattice, blocked);
    writePicture(path("published.svg"), content);
    EXPECT_LT(std::filesystem::file_size(path("published.svg")), 3'000'000u);
}

TEST_P(PictureOfEitherLattice, EveryPixelOfAnImageShowsTheCellUnderItsCentre)
{
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    struct View
    {
        double pitch;
        std::int64_t columns;
        std::int64_t rows;
        std::optional<Box> crop;
    };
    const View smallCells{20.0, 320, 250, std::nullopt};
    const View cellsBelowAPixel{7.0, 900, 800, std::nullopt};
    // 2 pixels a cell, the borders of squares through the pixels' centres.
    const View bordersOnCentres{20.0, 370, 290, Box{{-2995.0, -3605.0}, {-2995.0 + 7200.0, -3605.0 + 5600.0}}};
    for (const View &view : {smallCells, cellsBelowAPixel, bordersOnCentres})
    {
        const Lattice lattice = latticeOf({-3000.0, 2000.0}, view.pitch, view.columns, view.rows);
        const std::vector<OffsetCoord> blocked = randomCells(lattice, seed);
        PictureContent content{metricFrame(), occupancyOf(lattice, blocked)};
        content.widthPx = 800;
        content.crop = view.crop;
        writePicture(path("cells.png"), content);
        const Image image(path("cells.png"));
        const PictureFrame frame = pictureFrame(content);

        std::set<std::pair<int, int>> centres;
        for (const OffsetCoord cell : blocked)
        {
            const Point page = frame.toPage(lattice.centre(cell));
            centres.emplace(static_cast<int>(std::floor(page.x())), static_cast<int>(std::floor(page.y())));
        }
        std::size_t wrong = 0;
        std::size_t seen = 0;
        forEachPixel(frame, lattice,
                     [&](int x, int y, const Point &p)
                     {
                         ++seen;
                         const bool isCentre = centres.count({x, y}) != 0;
                         const bool expected = isCentre || content.occupancy->isBlocked(lattice.cellAt(p));
                         if (isTinted(image.at(x, y)) != expected)
                             wrong += isCentre || isSure(*content.occupancy, p, 1e-6 * view.pitch);
                     });
        EXPECT_EQ(wrong, 0U) << "of " << seen << " pixels, of " << view.columns << " columns";
        EXPECT_GT(seen, 100000U);
    }
}

TEST_P(PictureOfEitherLattice, EveryPixelWithinAnOutlineShowsItsCell)
{
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Lattice lattice = latticeOf({-3000.0, 2000.0}, 20.0, 61, 47);
    PictureContent content{metricFrame(), occupancyOf(lattice, randomCells(lattice, seed))};
    content.widthPx = 800;
    writePicture(path("cells.png"), content);
    const Image image(path("cells.png"));
    const PictureFrame frame = pictureFrame(content);
    std::size_t wrong = 0;
    std::size_t seen = 0;
    forEachPixel(frame, lattice,
                 [&](int x, int y, const Point &p)
                 {
                     const bool within = cellsNear(lattice, p, 1.4 / frame.pxPerUnitX).size() == 1;
                     seen += within;
                     wrong += within && isTinted(image.at(x, y)) != content.occupancy->isBlocked(lattice.cellAt(p));
                 });
    EXPECT_EQ(wrong, 0U) << "of " << seen << " pixels";
    EXPECT_GT(seen, 100000U);
}

TEST_P(PictureOfEitherLattice, LoopsOfAnSvgEncloseTheBlockedCellsAndNothingElse)
{
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Lattice lattice = latticeOf({-3000.0, 2000.0}, 20.0, 40, 30);
    const std::vector<OffsetCoord> blocked = randomCells(lattice, seed);
    const PictureContent content{metricFrame(), occupancyOf(lattice, blocked)};
    writePicture(path("cells.svg"), content);
    const PictureFrame frame = pictureFrame(content);

    // What is outside is blocked too: a belt of one cell runs around the lattice.
    double area = 0.0;
    for (const std::vector<Point> &loop : tintedLoops(contentsOf(path("cells.svg"))))
        area += signedArea(loop);
    const double cellPx = lattice.cellArea() * frame.pxPerUnitX * frame.pxPerUnitY;
    const double belt = 2.0 * 40 + 2.0 * 32;
    EXPECT_NEAR(area / cellPx, belt + static_cast<double>(blocked.size()), 0.5) << "corners stand at eighths of pixels";
}

// Few cells in view, and so many that the others are an image.
TEST_P(PictureOfEitherLattice, CellsOfThePathAreMarkedAndNoOthers)
{
    for (const std::int64_t columns : {30, 320})
    {
        const Lattice lattice = latticeOf({-3000.0, 2000.0}, 20.0, columns, 250);
        PictureContent content{metricFrame(), occupancyOf(lattice, {})};
        content.widthPx = 2000;
        const Point beyond = Point::Constant(60.0);
        content.crop = Box{lattice.bounds().min - beyond, lattice.bounds().max + beyond};
        const CellLayout &layout = content.occupancy->layout();
        const std::set<OffsetCoord> marked{{5, 5}, {6, 5}, {7, 6}, {8, 7}, {8, 9}};
        for (const OffsetCoord cell : marked)
            content.pathCells.push_back(layout.index(cell));
        content.pathCells.push_back(layout.index(OffsetCoord{5, 5}));  // once more
        content.pathCells.push_back(layout.index(OffsetCoord{-1, 7}));
        content.expanded = {layout.index(OffsetCoord{6, 5}), layout.index(OffsetCoord{-1, 9})};
        writePicture(path("path.png"), content);
        const Image image(path("path.png"));
        const PictureFrame frame = pictureFrame(content);
        for (std::int64_t row = 3; row < 12; ++row)
            for (std::int64_t column = -1; column < 12; ++column)
            {
                const Point page = frame.toPage(lattice.centre({column, row}));
                const bool isMarked = marked.count({column, row}) != 0;
                EXPECT_EQ(bool(isNear(image.around(page, 1), palette::pathCell, 8)), isMarked) << column << " " << row;
            }
        const Colour outside = blend(palette::water, palette::blocked, palette::blockedOpacity);
        for (const OffsetCoord cell : {OffsetCoord{-1, 7}, OffsetCoord{-1, 9}})
            EXPECT_TRUE(isNear(image.around(frame.toPage(lattice.centre(cell)), 1), outside)) << cell.row;
    }
}

TEST(PictureOfSquares, BlockedSquaresThatShareOnlyACornerHaveOutlinesOfTheirOwn)
{
    const PictureContent content{metricFrame(),
                                 occupancyOf(SquareLattice({0.0, 0.0}, 20.0, 6, 5), {{1, 1}, {2, 2}, {3, 1}, {3, 3}})};
    const test::TemporaryFolder folder;
    const std::string file = folder / "cells.svg";
    writePicture(file, content);
    const PictureFrame frame = pictureFrame(content);
    std::vector<long> cells;
    for (const std::vector<Point> &loop : tintedLoops(contentsOf(file)))
        cells.push_back(std::lround(signedArea(loop) / (400.0 * frame.pxPerUnitX * frame.pxPerUnitY)));
    std::sort(cells.begin(), cells.end());
    // Between inner and outer border, the belt that is around every lattice.
    EXPECT_EQ(cells, (std::vector<long>{-30, 1, 1, 1, 1, 56}));
}

INSTANTIATE_TEST_SUITE_P(, PictureOfEitherLattice, testing::Values(Cells::Hexagons, Cells::Squares),
                         [](const auto &test) { return test.param == Cells::Squares ? "Squares" : "Hexagons"; });

}  // namespace seahex
