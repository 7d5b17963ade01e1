#pragma once

#include "PictureCanvas.h"

#include "seahex/geometry/Lattice.h"

#include <cstdint>

namespace seahex
{

/// An image of the map's size, in its pixels, on which cells are painted one by one.
class CellImage
{
public:
    explicit CellImage(const PictureFrame &frame);

    /// Paints the pixels whose centre lies in the cell and the one in which the cell's centre lies. The last colour
    /// wins. A pixel's centre on the border of several cells lies in exactly one of them.
    void paintCell(const Lattice &lattice, OffsetCoord cell, std::uint32_t argb);

    /// Gives every painted pixel beside one that isn't painted (none of the image's own border) this colour.
    void paintRim(std::uint32_t argb);

    /// Lays the image over the canvas's map.
    void drawOn(PictureCanvas &canvas) const;

    /// A pixel as cairo stores it: opacity and colours, these multiplied by the opacity.
    static std::uint32_t pixel(const Colour &colour, double opacity);

private:
    struct Release
    {
        void operator()(cairo_surface_t *surface) const { cairo_surface_destroy(surface); }
    };

    std::uint32_t *row(int y) const { return pixels_ + static_cast<std::ptrdiff_t>(y) * stride_; }

    PictureFrame frame_;
    int width_;
    int height_;
    std::unique_ptr<cairo_surface_t, Release> surface_;
    std::uint32_t *pixels_ = nullptr;
    std::ptrdiff_t stride_ = 0;  ///< pixels from row to row
};

}  // namespace seahex
