#include "PictureLegend.h"

#include "CellCorners.h"
#include "PictureCells.h"
#include "PictureMap.h"
#include "PictureTitle.h"

#include "seahex/io/ScaleBar.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace seahex
{

namespace
{

constexpr double scaleBarWidth = 300.0;
constexpr double legendLeft = 500.0;
constexpr double entryWidth = 268.0;  // a long text takes the room of two
constexpr double entryHeight = 34.0;
constexpr std::size_t entriesAcross = 4;
constexpr double swatchWidth = 34.0;
constexpr double textGap = 10.0;  // before and after an entry's text
constexpr double wideSwatchWidth = 150.0;

const TextStyle small{14.0, false, false, 0.0, palette::ink};

TextStyle aligned(TextStyle style, double align)
{
    style.align = align;
    return style;
}

// 12345 -> "12,345"
std::string grouped(std::size_t number)
{
    std::string text = std::to_string(number);
    for (std::size_t at = text.size(); at > 3; at -= 3)
        text.insert(at - 3, ",");
    return text;
}

void drawScaleBar(PictureCanvas &canvas, double top, const ScaleBar &bar)
{
    const double from = canvas.units(pictureLeft);
    const double whole = bar.lengthM / canvas.frame().metresPerPx;
    const double height = canvas.units(6.0);
    const double part = whole / bar.parts;
    for (int i = 0; i < bar.parts; i += 2)
        canvas.rectangle({{from + i * part, top}, {from + (i + 1) * part, top + height}});
    canvas.fill(palette::ink);
    cairo_new_path(canvas.cairo());
    canvas.rectangle({{from, top}, {from + whole, top + height}});
    canvas.stroke(palette::ink, 1.0);
    const double baseline = top - canvas.units(5.0);
    canvas.text({from, baseline}, "0", aligned(small, 0.5));
    canvas.text({from + whole, baseline}, plainNumber(bar.length, 9), aligned(small, 0.5));
    canvas.text({from + whole + canvas.units(9.0), top + canvas.units(8.0)}, bar.unit, small);
}

void drawScaleBars(PictureCanvas &canvas)
{
    const PictureFrame &frame = canvas.frame();
    const double availableM =
        std::min(canvas.units(scaleBarWidth), frame.map.max.x() - frame.map.min.x()) * frame.metresPerPx;
    drawScaleBar(canvas, frame.legendTop + canvas.units(30.0), metricScaleBar(availableM));
    drawScaleBar(canvas, frame.legendTop + canvas.units(72.0), nauticalScaleBar(availableM));
}

// One place in the legend: a sample is drawn into the box, the text stands right of it.
struct Entry
{
    std::string text;
    std::function<void(PictureCanvas &, const Box &)> draw;
    double swatch = swatchWidth;
};

Entry areaEntry(const std::string &text, const Colour &colour, const Colour &edge)
{
    return {text, [colour, edge](PictureCanvas &canvas, const Box &box)
            {
                canvas.rectangle(box);
                canvas.fill(colour);
                canvas.stroke(edge, 1.0);
            }};
}

Entry lineEntry(const std::string &text, void (*strokeLine)(PictureCanvas &))
{
    return {text, [strokeLine](PictureCanvas &canvas, const Box &box)
            {
                const double y = 0.5 * (box.min.y() + box.max.y());
                cairo_move_to(canvas.cairo(), box.min.x(), y);
                cairo_line_to(canvas.cairo(), box.max.x(), y);
                strokeLine(canvas);
            }};
}

// Two cells of the lattice's kind side by side, sized to the box: calls draw(which) with the path of each.
template <class Draw>
void forEachSampleCell(PictureCanvas &canvas, const Box &box, const Lattice &lattice, Draw &&draw)
{
    const Lattice sample = lattice.squares() != nullptr ? Lattice(SquareLattice({0.0, 0.0}, 1.0, 2, 1))
                                                        : Lattice(HexLattice({0.0, 0.0}, 1.0, 2, 1));
    const double pitch = (box.max.x() - box.min.x()) / 2.5;
    const Point middle = 0.5 * (sample.centre({0, 0}) + sample.centre({1, 0}));
    for (std::int64_t column = 0; column < 2; ++column)
    {
        for (const CellCorner corner : cornersOf(sample, {column, 0}))
        {
            const Point p = pitch * (toPlane(sample, corner) - middle);
            const Point page = 0.5 * (box.min + box.max) + Point(p.x(), -p.y());
            cairo_line_to(canvas.cairo(), page.x(), page.y());
        }
        cairo_close_path(canvas.cairo());
        draw(column);
    }
}

// One over deep water and one over what may lie below it.
Entry blockedEntry(const Lattice &lattice, const Colour &second)
{
    return {"blocked cells", [lattice, second](PictureCanvas &canvas, const Box &box)
            {
                forEachSampleCell(canvas, box, lattice,
                                  [&](std::int64_t which)
                                  {
                                      canvas.fill(blend(which == 0 ? palette::water : second, palette::blocked,
                                                        palette::blockedOpacity));
                                      canvas.stroke(palette::blocked, 0.8, palette::blockedEdgeOpacity);
                                  });
            }};
}

Entry pathCellsEntry(const Lattice &lattice)
{
    return {"cells of the path", [lattice](PictureCanvas &canvas, const Box &box)
            {
                forEachSampleCell(canvas, box, lattice, [&](std::int64_t) { strokePathCells(canvas); });
            }};
}

void drawSampleDanger(PictureCanvas &canvas, const Box &box)
{
    addDangerCross(canvas, 0.5 * (box.min + box.max));
    strokeDangers(canvas, false);
}

void drawColourScale(PictureCanvas &canvas, const Box &box)
{
    cairo_pattern_t *gradient = cairo_pattern_create_linear(box.min.x(), 0.0, box.max.x(), 0.0);
    constexpr int stops = 16;
    for (int i = 0; i <= stops; ++i)
    {
        const double at = static_cast<double>(i) / stops;
        const Colour colour = expansionColour(at);
        cairo_pattern_add_color_stop_rgb(gradient, at, colour.red, colour.green, colour.blue);
    }
    canvas.rectangle(box);
    cairo_set_source(canvas.cairo(), gradient);
    cairo_fill_preserve(canvas.cairo());
    cairo_pattern_destroy(gradient);
    canvas.stroke(palette::ink, 0.8);
}

std::vector<Entry> entriesFor(const PictureContent &content)
{
    std::vector<Entry> entries;
    if (content.route.size() > 1)
        entries.push_back(lineEntry(content.routeName, strokeRoute));
    if (content.rawPath.size() > 1)
        entries.push_back(lineEntry(content.rawPathName, strokeRawPath));
    if (!content.pathCells.empty())
        entries.push_back(pathCellsEntry(content.occupancy->lattice()));
    if (!content.land.empty())
        entries.push_back(areaEntry("land", palette::land, palette::landEdge));
    if (!content.shoals.empty())
        entries.push_back(areaEntry("too shallow", palette::shoal, palette::shoalEdge));
    const Colour below = content.shoals.empty() ? palette::water : palette::shoal;
    entries.push_back(blockedEntry(content.occupancy->lattice(), below));
    if (!content.dangers.empty())
        entries.push_back({"other hazards", drawSampleDanger});
    if (!content.expanded.empty())
        entries.push_back(
            {"first to last of " + grouped(content.expanded.size()) + " expansions", drawColourScale, wideSwatchWidth});
    return entries;
}

}  // namespace

void drawLegend(PictureCanvas &canvas, const PictureContent &content)
{
    const PictureFrame &frame = canvas.frame();
    drawScaleBars(canvas);
    std::size_t place = 0;
    for (const Entry &entry : entriesFor(content))
    {
        const double beside = canvas.units(entry.swatch + 2.0 * textGap);
        const double entryRoom = canvas.units(entryWidth);
        const std::size_t taken = beside + canvas.textWidth(entry.text, small) > entryRoom ? 2 : 1;
        if (place % entriesAcross + taken > entriesAcross)
            ++place;
        const Point corner{canvas.units(legendLeft) + static_cast<double>(place % entriesAcross) * entryRoom,
                           frame.legendTop +
                               canvas.units(18.0 + static_cast<double>(place / entriesAcross) * entryHeight)};
        const Point size{canvas.units(entry.swatch), canvas.units(18.0)};
        entry.draw(canvas, {corner, corner + size});
        canvas.text({corner.x() + size.x() + canvas.units(textGap), corner.y() + canvas.units(14.0)}, entry.text,
                    fittedStyle(canvas, entry.text, small, static_cast<double>(taken) * entryRoom - beside));
        place += taken;
    }
    if (!content.footer.empty())
        canvas.text({canvas.units(pictureLeft), frame.heightPx - canvas.units(18.0)}, content.footer,
                    {14.0, false, true, 0.0, palette::ink});
}

}  // namespace seahex
