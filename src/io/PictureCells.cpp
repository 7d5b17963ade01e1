#include "PictureCells.h"

#include "CellGrid.h"
#include "CellImage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace seahex
{

namespace
{

constexpr std::int64_t mostOutlinedCells = 60000;
constexpr int bands = 24;  // shades of expansion among outlines; an image has 256

double moment(std::size_t i, std::size_t count)
{
    return count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
}

}  // namespace

void strokePathCells(PictureCanvas &canvas)
{
    canvas.fill(palette::pathCell);
    canvas.stroke(palette::route, 0.8);
}

PictureCells::PictureCells(PictureCanvas &canvas, const PictureContent &content)
    : canvas_(canvas), content_(content), occupancy_(*content.occupancy), lattice_(occupancy_.lattice()),
      window_(windowOver(lattice_, canvas.frame().plane))
{
}

bool PictureCells::asOutlines() const
{
    return window_.cellCount() <= mostOutlinedCells;
}

template <class Corners>
void PictureCells::addLoop(const Corners &corners)
{
    cairo_new_sub_path(canvas_.cairo());
    for (const CellCorner corner : corners)
    {
        const Point page = toPage(canvas_.frame(), lattice_, corner);
        cairo_line_to(canvas_.cairo(), page.x(), page.y());
    }
    cairo_close_path(canvas_.cairo());
}

void PictureCells::addOutlineOf(const std::function<bool(OffsetCoord)> &inside)
{
    for (const std::vector<CellCorner> &loop : outlineOf(lattice_, window_, inside))
        addLoop(loop);
}

bool PictureCells::isInView(OffsetCoord cell) const
{
    return window_.contains(cell) && lattice_.contains(cell);
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
        if (!isInView(cell))
            continue;
        int &band = bandOf[window_.position(cell)];
        if (band < 0)
            band = std::min(bands - 1, static_cast<int>(bands * moment(i, content_.expanded.size())));
    }
    for (int band = 0; band < bands; ++band)
    {
        addOutlineOf([&](OffsetCoord cell) { return bandOf[window_.position(cell)] == band; });
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
        if (isInView(cell))
            image.paintCell(lattice_, cell, shades[i * shades.size() / count]);
    }
    image.drawOn(canvas_);
}

// As outlines even where the others are an image, for a path has few; each by itself, so that they can be counted.
void PictureCells::drawPathCells()
{
    // Of a cell named twice the even-odd rule would fill nothing.
    const std::set<CellIndex> marked(content_.pathCells.begin(), content_.pathCells.end());
    for (const CellIndex index : marked)
        if (const OffsetCoord cell = occupancy_.layout().offset(index); isInView(cell))
            addLoop(cornersOf(lattice_, cell));
    strokePathCells(canvas_);
}

void PictureCells::drawBlocked()
{
    drawOutside();
    // The window holds a belt of cells around the lattice, which are blocked: they fill the notches of its edges. What
    // they cover beyond its bounds is tinted already.
    canvas_.clip(latticeOnPage());
    if (asOutlines())
    {
        addOutlineOf([this](OffsetCoord cell) { return occupancy_.isBlocked(cell); });
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
                const OffsetCoord cell{column, row};
                if (occupancy_.isBlocked(cell))
                    image.paintCell(lattice_, cell, tint);
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
    const Box bounds = lattice_.bounds();
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
    if (!asOutlines())
        return;
    canvas_.clip(latticeOnPage());
    drawCellGrid(canvas_, lattice_, window_);
    canvas_.unclip();
}

}  // namespace seahex
