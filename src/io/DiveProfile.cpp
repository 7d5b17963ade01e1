#include "seahex/io/DiveProfile.h"

#include "PictureCanvas.h"
#include "PictureFile.h"
#include "PictureFormat.h"
#include "PictureTitle.h"

#include "seahex/io/Picture.h"
#include "seahex/io/ScaleBar.h"

#include <algorithm>
#include <cmath>

namespace seahex
{
namespace
{

constexpr std::size_t mostMarked = 60;  // waypoints

const TextStyle small{14.0, false, false, 0.0, palette::ink};

TextStyle aligned(double align)
{
    TextStyle style = small;
    style.align = align;
    return style;
}

bool isFinite(const ProfilePoint &p)
{
    return std::isfinite(p.distanceM) && std::isfinite(p.depthM);
}

std::vector<ProfilePoint> finiteOf(const std::vector<ProfilePoint> &points, const char *name)
{
    std::vector<ProfilePoint> finite;
    std::copy_if(points.begin(), points.end(), std::back_inserter(finite), isFinite);
    if (finite.size() < 2)
        throw PictureError(std::string("the profile's ") + name + " has fewer than two points");
    return finite;
}

/// A round step, 1, 2 or 5 times a power of ten, of which about `count` fill the span.
double roundStep(double span, double count)
{
    const double raw = span / count;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= raw)
            return factor * power;
    return 10.0 * power;
}

/// The section on its page: distances to the right, depths down.
class Section
{
public:
    Section(PictureCanvas &canvas, const DiveProfileContent &content)
        : canvas_(canvas), content_(content), path_(finiteOf(content.path, "path")),
          seabed_(finiteOf(content.seabed, "seabed")), box_{{canvas.units(pictureLeft),
                                                             canvas.units(30.0 + titleHeight(content.title))},
                                                            {canvas.units(pictureRight),
                                                             canvas.frame().heightPx - canvas.units(104.0)}}
    {
        farthest_ = std::max({path_.back().distanceM, seabed_.back().distanceM, 1e-3});
        for (const auto *line : {&path_, &seabed_})
            for (const ProfilePoint &p : *line)
            {
                shoalest_ = std::min(shoalest_, p.depthM);
                deepest_ = std::max(deepest_, p.depthM);
            }
        deepest_ += 0.06 * std::max(deepest_ - shoalest_, 1e-3);
    }

    void draw()
    {
        canvas_.clip(box_);
        canvas_.rectangle(box_);
        canvas_.fill(palette::paper);
        cairo_new_path(canvas_.cairo());
        drawWaterAndSeabed();
        drawLimits();
        drawPath();
        canvas_.unclip();
        drawAxes();
        drawLegend();
    }

private:
    Point at(const ProfilePoint &p) const
    {
        return {box_.min.x() + p.distanceM / farthest_ * (box_.max.x() - box_.min.x()),
                box_.min.y() + (p.depthM - shoalest_) / (deepest_ - shoalest_) * (box_.max.y() - box_.min.y())};
    }

    void trace(const std::vector<ProfilePoint> &line, double raisedM = 0.0)
    {
        for (const ProfilePoint &p : line)
        {
            const Point page = at({p.distanceM, p.depthM - raisedM});
            cairo_line_to(canvas_.cairo(), page.x(), page.y());
        }
    }

    void drawWaterAndSeabed()
    {
        const Point surface = at({0.0, 0.0});
        canvas_.rectangle({{box_.min.x(), surface.y()}, box_.max});
        canvas_.fill(palette::shoal, 0.55);
        cairo_new_path(canvas_.cairo());
        cairo_move_to(canvas_.cairo(), box_.min.x(), box_.max.y());
        trace(seabed_);
        cairo_line_to(canvas_.cairo(), at(seabed_.back()).x(), box_.max.y());
        cairo_close_path(canvas_.cairo());
        canvas_.fill(palette::land);
        cairo_new_path(canvas_.cairo());
        trace(seabed_);
        canvas_.stroke(palette::landEdge, 1.6);
    }

    void dashed(bool isDashed)
    {
        const double dash[] = {canvas_.units(7.0), canvas_.units(5.0)};
        cairo_set_dash(canvas_.cairo(), dash, isDashed ? 2 : 0, 0.0);
    }

    void strokeLimit(const Colour &colour)
    {
        dashed(true);
        canvas_.stroke(colour, 1.4);
        dashed(false);
    }

    void level(double depthM)
    {
        trace({{0.0, depthM}, {farthest_, depthM}});
        strokeLimit(palette::shoalEdge);
    }

    void drawLimits()
    {
        trace(seabed_, content_.clearanceM);
        strokeLimit(palette::blocked);
        level(content_.ceilingM);
        if (std::isfinite(content_.deepestM))
            level(content_.deepestM);
    }

    void dot(const Point &page, double radius)
    {
        cairo_new_path(canvas_.cairo());
        cairo_arc(canvas_.cairo(), page.x(), page.y(), canvas_.units(radius), 0.0, 2.0 * M_PI);
        canvas_.fill(palette::route);
        cairo_new_path(canvas_.cairo());
    }

    void drawPath()
    {
        trace(path_);
        canvas_.stroke(palette::route, 3.0);
        if (path_.size() <= mostMarked)
            for (const ProfilePoint &p : path_)
                dot(at(p), 3.4);
        dot(at(path_.front()), 6.0);
        dot(at(path_.back()), 6.0);
    }

    void drawAxes()
    {
        canvas_.rectangle(box_);
        canvas_.stroke(palette::ink, 1.0);
        const double step = roundStep(deepest_ - shoalest_, 7.0);
        for (double depth = std::ceil(shoalest_ / step) * step; depth <= deepest_; depth += step)
        {
            const Point page = at({0.0, depth});
            tick(page, {page.x() - canvas_.units(6.0), page.y()});
            canvas_.text({page.x() - canvas_.units(11.0), page.y() + canvas_.units(5.0)}, plainNumber(depth, 3),
                         aligned(1.0));
        }
        const bool inKm = farthest_ >= 2000.0;
        const double unitM = inKm ? 1000.0 : 1.0;
        const double across = roundStep(farthest_ / unitM, 9.0);
        for (double x = 0.0; x * unitM <= farthest_; x += across)
        {
            const Point page(at({x * unitM, 0.0}).x(), box_.max.y());
            tick(page, {page.x(), page.y() + canvas_.units(6.0)});
            canvas_.text({page.x(), page.y() + canvas_.units(22.0)}, plainNumber(x, 6), aligned(0.5));
        }
        canvas_.text({canvas_.units(30.0), box_.min.y() - canvas_.units(10.0)}, "depth, m", small);
        canvas_.text({box_.max.x(), box_.max.y() + canvas_.units(42.0)},
                     std::string("distance along the track, ") + (inKm ? "km" : "m"), aligned(1.0));
    }

    void tick(const Point &from, const Point &to)
    {
        cairo_move_to(canvas_.cairo(), from.x(), from.y());
        cairo_line_to(canvas_.cairo(), to.x(), to.y());
        canvas_.stroke(palette::ink, 1.0);
    }

    double sample(double x, double y, const Colour &colour, double width, bool isDashed, const std::string &text)
    {
        dashed(isDashed);
        cairo_move_to(canvas_.cairo(), x, y - canvas_.units(5.0));
        cairo_line_to(canvas_.cairo(), x + canvas_.units(34.0), y - canvas_.units(5.0));
        canvas_.stroke(colour, width);
        dashed(false);
        canvas_.text({x + canvas_.units(43.0), y}, text, small);
        return x + canvas_.units(75.0) + canvas_.textWidth(text, small);
    }

    void drawLegend()
    {
        const double y = box_.max.y() + canvas_.units(70.0);
        double x = sample(box_.min.x(), y, palette::route, 3.0, false, "dive");
        x = sample(x, y, palette::landEdge, 1.6, false, "seabed");
        x = sample(x, y, palette::blocked, 1.4, true, "clearance of " + plainNumber(content_.clearanceM, 2) + " m");
        std::string limits = "ceiling at " + plainNumber(content_.ceilingM, 2) + " m";
        if (std::isfinite(content_.deepestM))
            limits += ", deepest at " + plainNumber(content_.deepestM, 2) + " m";
        sample(x, y, palette::shoalEdge, 1.4, true, limits);
        canvas_.text({box_.max.x(), y}, content_.footer, aligned(1.0));
    }

    PictureCanvas &canvas_;
    const DiveProfileContent &content_;
    std::vector<ProfilePoint> path_;
    std::vector<ProfilePoint> seabed_;
    Box box_;
    double farthest_ = 0.0;
    double shoalest_ = 0.0;  // the surface, or the top of what stands above it
    double deepest_ = 0.0;
};

}  // namespace

void writeDiveProfile(const std::string &path, const DiveProfileContent &content)
{
    if (content.widthPx < 400 || content.widthPx > 8000)
        throw PictureError("a picture's width must be 400 to 8000 pixels, not " + std::to_string(content.widthPx));
    const PictureFormat format = pictureFormatOf(path);
    PictureFrame frame;
    frame.widthPx = content.widthPx;
    frame.heightPx = content.widthPx / 2;
    frame.unit = content.widthPx / 1600.0;
    PictureCanvas canvas(format, frame);
    drawTitle(canvas, content.title);
    Section(canvas, content).draw();
    replacePictureFile(path, canvas.finish());
}

}  // namespace seahex
