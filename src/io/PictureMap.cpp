#include "PictureMap.h"

#include "PictureBorder.h"
#include "PictureCells.h"
#include "PicturePath.h"

#include <cmath>
#include <unordered_set>

namespace seahex
{

namespace
{

constexpr double markerRadius = 13.0;
constexpr double markerDistance = 30.0;  // from the place to the middle of its letter

// Symbols closer than this to one drawn before are left out: a chart may hold a hundred thousand soundings.
constexpr double symbolSpacing = 3.0;

template <class Draw>
void forEachSparsePoint(PictureCanvas &canvas, const PicturePath &path, const std::vector<const Shape *> &shapes,
                        Draw &&draw)
{
    std::unordered_set<std::uint64_t> taken;
    const double spacing = canvas.units(symbolSpacing);
    for (const Shape *shape : shapes)
        for (const Point &p : shape->points)
        {
            const Point page = canvas.frame().toPage(p);
            if (!path.isNear(page))
                continue;
            const auto column = static_cast<std::int32_t>(std::floor(page.x() / spacing));
            const auto row = static_cast<std::int32_t>(std::floor(page.y() / spacing));
            const std::uint64_t spot =
                static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32 | static_cast<std::uint32_t>(row);
            if (taken.insert(spot).second)
                draw(page);
        }
}

void addAreas(PicturePath &path, const std::vector<const Shape *> &shapes)
{
    for (const Shape *shape : shapes)
        for (const Polygon &area : shape->areas)
            path.addArea(area);
}

void addLines(PicturePath &path, const std::vector<const Shape *> &shapes)
{
    for (const Shape *shape : shapes)
        for (const LineString &line : shape->lines)
            path.addLine(line);
}

// Each shape by itself: were all of them one path, areas that overlap (as two charts do) would cancel out.
void fillAreas(PictureCanvas &canvas, const std::vector<const Shape *> &shapes, const Colour &colour)
{
    PicturePath path(canvas);
    for (const Shape *shape : shapes)
        for (const Polygon &area : shape->areas)
        {
            path.addArea(area);
            canvas.fill(colour);
            cairo_new_path(canvas.cairo());
        }
}

void drawCoast(PictureCanvas &canvas, const PictureContent &content)
{
    PicturePath path(canvas);
    addAreas(path, content.shoals);
    addLines(path, content.shoals);
    canvas.stroke(palette::shoalEdge, 0.7, 0.9);
    for (const Shape *shape : content.land)
        for (const Polygon &area : shape->areas)
        {
            path.addArea(area);
            canvas.fill(palette::land);
            canvas.stroke(palette::landEdge, 1.0);
        }
    addLines(path, content.land);
    canvas.stroke(palette::landEdge, 1.0);
    forEachSparsePoint(canvas, path, content.land,
                       [&canvas](const Point &page)
                       {
                           cairo_new_sub_path(canvas.cairo());
                           cairo_arc(canvas.cairo(), page.x(), page.y(), canvas.units(2.6), 0.0, 2.0 * M_PI);
                           canvas.fill(palette::land);
                           canvas.stroke(palette::landEdge, 0.9);
                       });
}

void drawDangers(PictureCanvas &canvas, const PictureContent &content)
{
    PicturePath path(canvas);
    addAreas(path, content.dangers);
    strokeDangers(canvas, true);
    addLines(path, content.dangers);
    forEachSparsePoint(canvas, path, content.dangers, [&canvas](const Point &page) { addDangerCross(canvas, page); });
    strokeDangers(canvas, false);
}

void drawPaths(PictureCanvas &canvas, const PictureContent &content)
{
    PicturePath path(canvas);
    path.addLine(content.rawPath);
    strokeRawPath(canvas);
    path.addLine(content.route);
    strokeRoute(canvas);
}

// The letter stands off its place, away from the other end, so that neither hides the other or the route.
void drawEnd(PictureCanvas &canvas, const Point &place, const std::optional<Point> &otherEnd, const std::string &letter)
{
    const PictureFrame &frame = canvas.frame();
    const Point page = frame.toPage(place);
    if (!page.allFinite() || !frame.map.contains(page))
        return;
    Point away{0.0, -1.0};
    if (otherEnd && otherEnd->allFinite() && *otherEnd != place)
        away = (page - frame.toPage(*otherEnd)).normalized();
    else if (otherEnd)
        away = Point(letter == "A" ? -1.0 : 1.0, 0.0);
    const Point inset = Point::Constant(canvas.units(markerRadius + 2.0));
    const Point middle =
        (page + canvas.units(markerDistance) * away).cwiseMax(frame.map.min + inset).cwiseMin(frame.map.max - inset);
    cairo_move_to(canvas.cairo(), page.x(), page.y());
    cairo_line_to(canvas.cairo(), middle.x(), middle.y());
    canvas.stroke(palette::ink, 1.6);
    cairo_arc(canvas.cairo(), page.x(), page.y(), canvas.units(4.0), 0.0, 2.0 * M_PI);
    canvas.fill(palette::ink);
    canvas.stroke(palette::paper, 1.2);
    drawMarker(canvas, middle, letter);
}

}  // namespace

void strokeRawPath(PictureCanvas &canvas)
{
    cairo_path_t *path = cairo_copy_path(canvas.cairo());
    canvas.stroke(palette::paper, 3.0, 0.8);
    cairo_append_path(canvas.cairo(), path);
    cairo_path_destroy(path);
    canvas.stroke(palette::ink, 1.4);
}

void strokeRoute(PictureCanvas &canvas)
{
    cairo_path_t *path = cairo_copy_path(canvas.cairo());
    canvas.stroke(palette::paper, 6.4, 0.9);
    cairo_append_path(canvas.cairo(), path);
    cairo_path_destroy(path);
    canvas.stroke(palette::route, 3.6);
}

void addDangerCross(PictureCanvas &canvas, const Point &page)
{
    const double arm = canvas.units(3.6);
    for (const double sign : {-1.0, 1.0})
    {
        cairo_move_to(canvas.cairo(), page.x() - arm, page.y() - sign * arm);
        cairo_line_to(canvas.cairo(), page.x() + arm, page.y() + sign * arm);
    }
}

void strokeDangers(PictureCanvas &canvas, bool dashed)
{
    const double dashes[] = {canvas.units(4.0), canvas.units(3.5)};
    if (dashed)
        cairo_set_dash(canvas.cairo(), dashes, 2, 0.0);
    canvas.stroke(palette::ink, 1.1);
    cairo_set_dash(canvas.cairo(), nullptr, 0, 0.0);
}

void drawMarker(PictureCanvas &canvas, const Point &page, const std::string &letter)
{
    cairo_new_path(canvas.cairo());
    cairo_arc(canvas.cairo(), page.x(), page.y(), canvas.units(markerRadius), 0.0, 2.0 * M_PI);
    canvas.fill(palette::paper);
    canvas.stroke(palette::ink, 2.0);
    canvas.text({page.x(), page.y() + canvas.units(6.2)}, letter, {17.0, true, false, 0.5, palette::ink});
}

void drawMap(PictureCanvas &canvas, const PictureContent &content)
{
    PictureCells cells(canvas, content);
    canvas.clip(canvas.frame().map);
    canvas.rectangle(canvas.frame().map);
    canvas.fill(palette::water);
    cairo_new_path(canvas.cairo());
    fillAreas(canvas, content.shoals, palette::shoal);
    cells.drawExpanded();
    cells.drawBlocked();
    cells.drawPathCells();
    drawCoast(canvas, content);
    cells.drawGrid();
    drawGraticule(canvas, content.projection);
    drawDangers(canvas, content);
    drawPaths(canvas, content);
    if (content.start)
        drawEnd(canvas, *content.start, content.goal, "A");
    if (content.goal)
        drawEnd(canvas, *content.goal, content.start, "B");
    canvas.unclip();
}

}  // namespace seahex
