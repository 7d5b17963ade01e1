#pragma once

#include "PictureFormat.h"

#include "seahex/io/PictureFrame.h"
#include "seahex/io/PicturePalette.h"

#include <cairo.h>

#include <memory>
#include <string>

namespace seahex
{

/// How a piece of text sits at its point.
struct TextStyle
{
    double size = 15.0;  ///< in units of type
    bool bold = false;
    bool italic = false;
    double align = 0.0;  ///< 0: starts at the point, 0.5: centred, 1: ends there
    Colour colour = palette::ink;
};

/// A page to draw on: a cairo surface and the few operations that all parts of a picture share.
///
/// Widths of lines and sizes of type are given in units of type (PictureFrame::unit), places in page coordinates.
class PictureCanvas
{
public:
    PictureCanvas(PictureFormat format, const PictureFrame &frame);

    cairo_t *cairo() const { return cairo_.get(); }
    const PictureFrame &frame() const { return frame_; }
    double units(double value) const { return value * frame_.unit; }

    void setColour(const Colour &colour, double opacity = 1.0);
    void setLineWidth(double width);

    /// Fills the current path and keeps it.
    void fill(const Colour &colour, double opacity = 1.0);
    /// Strokes the current path and clears it.
    void stroke(const Colour &colour, double width, double opacity = 1.0);

    void rectangle(const Box &page);
    /// From here on nothing is drawn outside the box of the page, until unclip().
    void clip(const Box &page);
    void unclip();

    double textWidth(const std::string &text, const TextStyle &style);
    /// `at` lies on the baseline.
    void text(const Point &at, const std::string &text, const TextStyle &style);

    /// The finished file; nothing may be drawn afterwards.
    /// @throws PictureError if cairo met an error on the way
    std::string finish();

private:
    template <auto Destroy>
    struct Deleter
    {
        template <class T>
        void operator()(T *object) const
        {
            Destroy(object);
        }
    };

    void setFont(const TextStyle &style);

    PictureFormat format_;
    PictureFrame frame_;
    std::string bytes_;  ///< what cairo has written so far; its address is known to the surface
    std::unique_ptr<cairo_surface_t, Deleter<cairo_surface_destroy>> surface_;
    std::unique_ptr<cairo_t, Deleter<cairo_destroy>> cairo_;

public:
    PictureCanvas(const PictureCanvas &) = delete;
    PictureCanvas &operator=(const PictureCanvas &) = delete;
};

}  // namespace seahex
