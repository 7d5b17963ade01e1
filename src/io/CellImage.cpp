#include "CellImage.h"

#include "CellCorners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace seahex
{

namespace
{

// The first pixel whose centre lies at or beyond a place along an axis of `count` pixels.
int clampedPixel(double place, int count)
{
    return static_cast<int>(std::clamp(std::ceil(place - 0.5), 0.0, static_cast<double>(count)));
}

// Where a horizontal line enters and leaves a convex polygon. Cells that share an edge find the same place on it, as
// both reckon from its upper end: no pixel between them is left out or painted twice.
template <class Corners>
std::pair<double, double> crossings(const Corners &corners, double y)
{
    std::pair<double, double> ends{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        Point upper = corners[i];
        Point lower = corners[(i + 1) % corners.size()];
        if (upper.y() > lower.y())
            std::swap(upper, lower);
        if (y < upper.y() || y >= lower.y())
            continue;
        const double x = upper.x() + (lower.x() - upper.x()) * ((y - upper.y()) / (lower.y() - upper.y()));
        ends = {std::min(ends.first, x), std::max(ends.second, x)};
    }
    return ends;
}

}  // namespace

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

void CellImage::paintCell(const Lattice &lattice, OffsetCoord cell, std::uint32_t argb)
{
    boost::container::static_vector<Point, 6> corners;
    for (const CellCorner corner : cornersOf(lattice, cell))
        corners.push_back(frame_.toPage(toPlane(lattice, corner)) - frame_.map.min);
    // The first corner is a northernmost one, the opposite a southernmost.
    const int end = clampedPixel(corners[corners.size() / 2].y(), height_);
    for (int y = clampedPixel(corners.front().y(), height_); y < end; ++y)
    {
        const auto [west, east] = crossings(corners, y + 0.5);
        std::fill(row(y) + clampedPixel(west, width_), row(y) + clampedPixel(east, width_), argb);
    }
    const Point centre = frame_.toPage(lattice.centre(cell)) - frame_.map.min;
    if (centre.x() >= 0.0 && centre.x() < width_ && centre.y() >= 0.0 && centre.y() < height_)
        row(static_cast<int>(centre.y()))[static_cast<int>(centre.x())] = argb;
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
