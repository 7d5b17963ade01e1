#include "CellImage.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace seahex
{

CellImage::CellImage(const PictureFrame &frame)
    : frame_(frame), width_(static_cast<int>(std::lround(frame.map.max.x() - frame.map.min.x()))),
      height_(static_cast<int>(std::lround(frame.map.max.y() - frame.map.min.y()))),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width_, height_))
{
    if (cairo_surface_status(surface_.get()) != CAIRO_STATUS_SUCCESS)
        throw PictureError("no memory for an image of the cells of " + std::to_string(width_) + " x " +
                           std::to_string(height_) + " pixels");
    // cairo aligns rows to whole 32-bit words.
    void *data = cairo_image_surface_get_data(surface_.get());
    pixels_ = static_cast<std::uint32_t *>(data);
    stride_ = cairo_image_surface_get_stride(surface_.get()) / 4;
}

void CellImage::paintCell(const HexLattice &lattice, HexCoord cell, std::uint32_t argb)
{
    const Point centre = frame_.toPage(lattice.centre(cell)) - frame_.map.min;
    const double halfWidth = 0.5 * lattice.pitch() * frame_.pxPerUnitX;
    const double halfHeight = lattice.side() * frame_.pxPerUnitY;
    if (centre.x() + halfWidth < 0 || centre.x() - halfWidth > width_ || centre.y() + halfHeight < 0 ||
        centre.y() - halfHeight > height_)
        return;

    const int firstRow = std::max(0, static_cast<int>(std::ceil(centre.y() - halfHeight - 0.5)));
    const int lastRow = std::min(height_ - 1, static_cast<int>(std::floor(centre.y() + halfHeight - 0.5)));
    for (int y = firstRow; y <= lastRow; ++y)
    {
        // A pointy-top cell is full width in its middle half and tapers to its tips.
        const double fromTip = halfHeight - std::abs(y + 0.5 - centre.y());
        const double reach = halfWidth * std::min(1.0, 2.0 * fromTip / halfHeight);
        const int from = std::max(0, static_cast<int>(std::ceil(centre.x() - reach - 0.5)));
        const int to = std::min(width_, static_cast<int>(std::ceil(centre.x() + reach - 0.5)));
        if (from < to)
            std::fill(row(y) + from, row(y) + to, argb);
    }
    const int x = static_cast<int>(std::floor(centre.x()));
    const int y = static_cast<int>(std::floor(centre.y()));
    if (x >= 0 && x < width_ && y >= 0 && y < height_)
        row(y)[x] = argb;
}

void CellImage::paintRim(std::uint32_t argb)
{
    std::vector<std::ptrdiff_t> rim;
    for (int y = 0; y < height_; ++y)
    {
        const std::uint32_t *here = row(y);
        const std::uint32_t *above = row(std::max(0, y - 1));
        const std::uint32_t *below = row(std::min(height_ - 1, y + 1));
        for (int x = 0; x < width_; ++x)
            if (here[x] != 0 && (above[x] == 0 || below[x] == 0 || here[std::max(0, x - 1)] == 0 ||
                                 here[std::min(width_ - 1, x + 1)] == 0))
                rim.push_back(y * stride_ + x);
    }
    for (const std::ptrdiff_t at : rim)
        pixels_[at] = argb;
}

void CellImage::drawOn(PictureCanvas &canvas) const
{
    cairo_surface_mark_dirty(surface_.get());
    cairo_t *cairo = canvas.cairo();
    cairo_set_source_surface(cairo, surface_.get(), frame_.map.min.x(), frame_.map.min.y());
    cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
    canvas.rectangle(frame_.map);
    cairo_fill(cairo);
}

std::uint32_t CellImage::pixel(const Colour &colour, double opacity)
{
    const auto part = [opacity](double component)
    {
        return static_cast<std::uint32_t>(std::lround(255.0 * component * opacity));
    };
    return part(1.0) << 24 | part(colour.red) << 16 | part(colour.green) << 8 | part(colour.blue);
}

}  // namespace seahex
