#include "PictureCanvas.h"

#include <cairo-svg.h>

#include <exception>

namespace seahex
{

namespace
{

// Called by cairo, which is C: no exception may leave.
cairo_status_t append(void *bytes, const unsigned char *data, unsigned int length) noexcept
{
    try
    {
        static_cast<std::string *>(bytes)->append(reinterpret_cast<const char *>(data), length);
        return CAIRO_STATUS_SUCCESS;
    }
    catch (const std::exception &)
    {
        return CAIRO_STATUS_NO_MEMORY;
    }
}

cairo_surface_t *makeSurface(PictureFormat format, const PictureFrame &frame, std::string &bytes)
{
    if (format == PictureFormat::Png)
        return cairo_image_surface_create(CAIRO_FORMAT_RGB24, frame.widthPx, frame.heightPx);
    cairo_surface_t *surface = cairo_svg_surface_create_for_stream(append, &bytes, frame.widthPx, frame.heightPx);
    cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
    return surface;
}

void check(cairo_status_t status)
{
    if (status != CAIRO_STATUS_SUCCESS)
        throw PictureError(std::string("the picture could not be drawn: ") + cairo_status_to_string(status));
}

}  // namespace

PictureCanvas::PictureCanvas(PictureFormat format, const PictureFrame &frame)
    : format_(format), frame_(frame), surface_(makeSurface(format, frame, bytes_)), cairo_(cairo_create(surface_.get()))
{
    check(cairo_status(cairo_.get()));
    setColour(palette::paper);
    cairo_paint(cairo_.get());
    cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo_.get(), CAIRO_LINE_CAP_ROUND);
    // Rings come in no promised orientation.
    cairo_set_fill_rule(cairo_.get(), CAIRO_FILL_RULE_EVEN_ODD);
}

void PictureCanvas::setColour(const Colour &colour, double opacity)
{
    cairo_set_source_rgba(cairo(), colour.red, colour.green, colour.blue, opacity);
}

void PictureCanvas::setLineWidth(double width)
{
    cairo_set_line_width(cairo(), units(width));
}

void PictureCanvas::fill(const Colour &colour, double opacity)
{
    setColour(colour, opacity);
    cairo_fill_preserve(cairo());
}

void PictureCanvas::stroke(const Colour &colour, double width, double opacity)
{
    setColour(colour, opacity);
    setLineWidth(width);
    cairo_stroke(cairo());
}

void PictureCanvas::rectangle(const Box &page)
{
    cairo_rectangle(cairo(), page.min.x(), page.min.y(), page.max.x() - page.min.x(), page.max.y() - page.min.y());
}

void PictureCanvas::clip(const Box &page)
{
    cairo_save(cairo());
    rectangle(page);
    cairo_clip(cairo());
}

void PictureCanvas::unclip()
{
    cairo_restore(cairo());
}

void PictureCanvas::setFont(const TextStyle &style)
{
    cairo_select_font_face(cairo(), "sans-serif", style.italic ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo(), units(style.size));
}

double PictureCanvas::textWidth(const std::string &text, const TextStyle &style)
{
    setFont(style);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo(), text.c_str(), &extents);
    return extents.x_advance;
}

void PictureCanvas::text(const Point &at, const std::string &text, const TextStyle &style)
{
    const double width = style.align > 0.0 ? textWidth(text, style) : 0.0;
    setFont(style);
    setColour(style.colour);
    cairo_move_to(cairo(), at.x() - style.align * width, at.y());
    cairo_show_text(cairo(), text.c_str());
    cairo_new_path(cairo());
}

std::string PictureCanvas::finish()
{
    check(cairo_status(cairo()));
    if (format_ == PictureFormat::Png)
        check(cairo_surface_write_to_png_stream(surface_.get(), append, &bytes_));
    cairo_.reset();
    cairo_surface_finish(surface_.get());
    check(cairo_surface_status(surface_.get()));
    return bytes_;
}

}  // namespace seahex
