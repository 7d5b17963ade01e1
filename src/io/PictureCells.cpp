#include "PictureCells.h"

#include "CellImage.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace seahex
{

namespace
{

constexpr std::int64_t mostOutlinedCells = 60000;
constexpr int bands = 24;  // shades of expansion among outlines; an image has 256
constexpr double gridWidth = 0.45;
constexpr double gridOpacity = 0.16;
constexpr double leastGridPitch = 6.0;  // units of type

double moment(std::size_t i, std::size_t count)
{
    return count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
}

}  // namespace

PictureCells::PictureCells(PictureCanvas &canvas, const PictureContent &content)
    : canvas_(canvas), content_(content), occupancy_(*content.occupancy),
      window_(windowOver(content.occupancy->lattice(), canvas.frame().plane))
{
}

bool PictureCells::asOutlines() const
{
    return window_.cellCount() <= mostOutlinedCells;
}

// Eighths of a pixel are far below what is seen and take few digits in an SVG.
Point PictureCells::cornerOnPage(CellCorner corner) const
{
    const Point page = canvas_.frame().toPage(toPlane(occupancy_.lattice(), corner));
    return {std::round(8.0 * page.x()) / 8.0, std::round(8.0 * page.y()) / 8.0};
}

void PictureCells::addLoops(const std::vector<std::vector<CellCorner>> &loops)
{
    for (const std::vector<CellCorner> &loop : loops)
    {
        cairo_new_sub_path(canvas_.cairo());
        for (const CellCorner corner : loop)
        {
            const Point page = cornerOnPage(corner);
            cairo_line_to(canvas_.cairo(), page.x(), page.y());
        }
        cairo_close_path(canvas_.cairo());
    }
}

void PictureCells::drawExpanded()
{
    if (content_.expanded.empty())
        return;
    if (asOutlines())
        outlineExpanded();
    else
        paintExpanded();
}

void PictureCells::outlineExpanded()
{
    const CellLayout &layout = occupancy_.layout();
    std::vector<int> bandOf(static_cast<std::size_t>(window_.cellCount()), -1);
    for (std::size_t i = 0; i < content_.expanded.size(); ++i)
    {
        const OffsetCoord cell = layout.offset(content_.expanded[i]);
        if (!window_.contains(cell) || !occupancy_.lattice().contains(toCube(cell)))
            continue;
        int &band = bandOf[window_.position(cell)];
        if (band < 0)
            band = std::min(bands - 1, static_cast<int>(bands * moment(i, content_.expanded.size())));
    }
    for (int band = 0; band < bands; ++band)
    {
        addLoops(outlineOf(window_, [&](OffsetCoord cell) { return bandOf[window_.position(cell)] == band; }));
        const Colour colour = expansionColour((band + 0.5) / bands);
        canvas_.fill(colour);
        canvas_.stroke(colour, 0.6);  // closes the hairline that smoothing leaves between two fills
    }
}

void PictureCells::paintExpanded()
{
    std::array<std::uint32_t, 256> shades{};
    for (std::size_t i = 0; i < shades.size(); ++i)
        shades[i] = CellImage::pixel(expansionColour(moment(i, shades.size())), 1.0);

    CellImage image(canvas_.frame());
    const std::size_t count = content_.expanded.size();
    for (std::size_t i = count; i-- > 0;)  // backwards: where several cells share a pixel, the earliest shows
    {
        const OffsetCoord cell = occupancy_.layout().offset(content_.expanded[i]);
        if (window_.contains(cell) && occupancy_.lattice().contains(toCube(cell)))
            image.paintCell(occupancy_.lattice(), toCube(cell), shades[i * shades.size() / count]);
    }
    image.drawOn(canvas_);
}

void PictureCells::drawBlocked()
{
    drawOutside();
    // The window holds a belt of cells around the lattice, which are blocked: they fill the notches of its edges. What
    // they cover beyond its bounds is tinted already.
    canvas_.clip(latticeOnPage());
    if (asOutlines())
    {
        addLoops(outlineOf(window_, [this](OffsetCoord cell) { return occupancy_.isBlocked(toCube(cell)); }));
        canvas_.fill(palette::blocked, palette::blockedOpacity);
        canvas_.stroke(palette::blocked, 0.8, palette::blockedEdgeOpacity);
    }
    else
    {
        CellImage image(canvas_.frame());
        const std::uint32_t tint = CellImage::pixel(palette::blocked, palette::blockedOpacity);
        for (std::int64_t row = window_.firstRow; row <= window_.lastRow; ++row)
            for (std::int64_t column = window_.firstColumn; column <= window_.lastColumn; ++column)
            {
                const HexCoord cell = toCube(OffsetCoord{column, row});
                if (occupancy_.isBlocked(cell))
                    image.paintCell(occupancy_.lattice(), cell, tint);
            }
        image.paintRim(CellImage::pixel(palette::blocked, palette::blockedEdgeOpacity));
        image.drawOn(canvas_);
    }
    canvas_.unclip();
}

// The part of the map that the lattice's bounds fill.
Box PictureCells::latticeOnPage() const
{
    const PictureFrame &frame = canvas_.frame();
    const Box bounds = occupancy_.lattice().bounds();
    const Point upperLeft = frame.toPage({bounds.min.x(), bounds.max.y()});
    const Point lowerRight = frame.toPage({bounds.max.x(), bounds.min.y()});
    return {upperLeft.cwiseMax(frame.map.min).cwiseMin(frame.map.max),
            lowerRight.cwiseMin(frame.map.max).cwiseMax(frame.map.min)};
}

// Everything outside the lattice is blocked.
void PictureCells::drawOutside()
{
    canvas_.rectangle(canvas_.frame().map);
    canvas_.rectangle(latticeOnPage());
    canvas_.fill(palette::blocked, palette::blockedOpacity);
    cairo_new_path(canvas_.cairo());
}

void PictureCells::drawGrid()
{
    const double pitchPx = occupancy_.lattice().pitch() * canvas_.frame().pxPerUnitX;
    if (!asOutlines() || pitchPx < canvas_.units(leastGridPitch))
        return;
    canvas_.clip(latticeOnPage());
    addZigzags();
    canvas_.stroke(palette::ink, gridWidth, gridOpacity);
    addUprights();
    // Along one meridian of the lattice the upright edges are as long as a side and two sides apart.
    const double sidePx = occupancy_.lattice().side() * canvas_.frame().pxPerUnitY;
    const double dashes[] = {sidePx, 2.0 * sidePx};
    cairo_set_line_cap(canvas_.cairo(), CAIRO_LINE_CAP_BUTT);
    cairo_set_dash(canvas_.cairo(), dashes, 2, 0.0);
    canvas_.stroke(palette::ink, gridWidth, gridOpacity);
    canvas_.unclip();
}

// The line between each two rows.
void PictureCells::addZigzags()
{
    for (std::int64_t row = std::max<std::int64_t>(window_.firstRow, 0); row <= window_.lastRow; ++row)
    {
        cairo_new_sub_path(canvas_.cairo());
        for (std::int64_t column = std::max<std::int64_t>(window_.firstColumn, 0); column <= window_.lastColumn;
             ++column)
        {
            const std::array<CellCorner, 6> corners = cornersOf({column, row});
            for (const CellCorner corner : {corners[5], corners[0]})
            {
                const Point page = cornerOnPage(corner);
                cairo_line_to(canvas_.cairo(), page.x(), page.y());
            }
        }
    }
}

// Lines along the western edges of every second row, to be dashed.
void PictureCells::addUprights()
{
    const std::int64_t firstRow = std::max<std::int64_t>(window_.firstRow, 0);
    const std::int64_t lastRow = std::min(window_.lastRow, occupancy_.lattice().rows() - 1);
    for (std::int64_t row = firstRow; row <= std::min(firstRow + 1, lastRow); ++row)
        for (std::int64_t column = std::max<std::int64_t>(window_.firstColumn, 0); column <= window_.lastColumn;
             ++column)
        {
            const std::int64_t end = lastRow - (lastRow - row) % 2;
            const Point upper = cornerOnPage(cornersOf({column, row})[5]);
            const Point lower = cornerOnPage(cornersOf({column, end})[4]);
            cairo_move_to(canvas_.cairo(), upper.x(), upper.y());
            cairo_line_to(canvas_.cairo(), lower.x(), lower.y());
        }
}

}  // namespace seahex
