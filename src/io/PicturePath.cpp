#include "PicturePath.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace seahex
{

namespace
{

constexpr double marginUnits = 40.0;
constexpr double thinningUnits = 1.0 / 3.0;

std::vector<Point> thinned(const std::vector<Point> &line, const PictureFrame &frame)
{
    const double least = std::pow(thinningUnits * frame.unit, 2);
    std::vector<Point> kept;
    Point last = Point::Zero();
    for (const Point &p : line)
    {
        Point page = frame.toPage(p);
        if (!page.allFinite())
            continue;
        page = (8.0 * page).array().round() / 8.0;  // an eighth of a pixel is not seen and takes few digits in an SVG
        last = page;
        if (kept.empty() || (page - kept.back()).squaredNorm() >= least)
            kept.push_back(page);
    }
    if (!kept.empty() && kept.back() != last)
        kept.push_back(last);
    return kept;
}

Box boundsOf(const std::vector<Point> &points)
{
    Box box{points.front(), points.front()};
    for (const Point &p : points)
    {
        box.min = box.min.cwiseMin(p);
        box.max = box.max.cwiseMax(p);
    }
    return box;
}

// One step of Sutherland and Hodgman's clipping: what lies on the side where sign * (p[axis] - bound) <= 0.
std::vector<Point> cutRing(const std::vector<Point> &ring, int axis, double bound, double sign)
{
    std::vector<Point> inside;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const Point &a = ring[i];
        const Point &b = ring[(i + 1) % ring.size()];
        const double da = sign * (a[axis] - bound);
        const double db = sign * (b[axis] - bound);
        if (da <= 0.0)
            inside.push_back(a);
        if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0))
            inside.push_back(a + (b - a) * (da / (da - db)));
    }
    return inside;
}

// Shortens the segment to its part within the box (Liang and Barsky); false if there is none.
bool cutSegment(Point &a, Point &b, const Box &box)
{
    double from = 0.0;
    double to = 1.0;
    const Point d = b - a;
    for (int axis = 0; axis < 2; ++axis)
    {
        if (d[axis] == 0.0)
        {
            if (a[axis] < box.min[axis] || a[axis] > box.max[axis])
                return false;
            continue;
        }
        double enter = (box.min[axis] - a[axis]) / d[axis];
        double leave = (box.max[axis] - a[axis]) / d[axis];
        if (enter > leave)
            std::swap(enter, leave);
        from = std::max(from, enter);
        to = std::min(to, leave);
    }
    if (from > to)
        return false;
    const Point start = a;
    if (from > 0.0)
        a = start + from * d;
    if (to < 1.0)
        b = start + to * d;
    return true;
}

}  // namespace

PicturePath::PicturePath(PictureCanvas &canvas) : canvas_(canvas), margin_(canvas.frame().map)
{
    const Point more = Point::Constant(canvas.units(marginUnits));
    margin_.min -= more;
    margin_.max += more;
}

void PicturePath::addArea(const Polygon &area)
{
    addRing(area.outer());
    for (const Ring &hole : area.inners())
        addRing(hole);
}

void PicturePath::addRing(const Ring &ring)
{
    std::vector<Point> page = thinned(ring, canvas_.frame());
    if (page.empty())
        return;
    const Box bounds = boundsOf(page);
    if ((bounds.min.array() > margin_.max.array()).any() || (bounds.max.array() < margin_.min.array()).any())
        return;
    if (page.size() < 3)
    {
        const Point half = Point::Constant(canvas_.units(0.5));
        canvas_.rectangle({page.front() - half, page.front() + half});
        return;
    }
    if (!margin_.contains(bounds.min) || !margin_.contains(bounds.max))
    {
        for (int axis = 0; axis < 2; ++axis)
        {
            page = cutRing(page, axis, margin_.max[axis], 1.0);
            page = cutRing(page, axis, margin_.min[axis], -1.0);
        }
    }
    cairo_new_sub_path(canvas_.cairo());
    for (const Point &p : page)
        cairo_line_to(canvas_.cairo(), p.x(), p.y());
    if (!page.empty())
        cairo_close_path(canvas_.cairo());
}

void PicturePath::addLine(const LineString &line)
{
    const std::vector<Point> page = thinned(line, canvas_.frame());
    bool drawing = false;
    for (std::size_t i = 1; i < page.size(); ++i)
    {
        Point a = page[i - 1];
        Point b = page[i];
        if (!cutSegment(a, b, margin_))
        {
            drawing = false;
            continue;
        }
        if (!drawing || a != page[i - 1])
            cairo_move_to(canvas_.cairo(), a.x(), a.y());
        cairo_line_to(canvas_.cairo(), b.x(), b.y());
        drawing = b == page[i];
    }
}

}  // namespace seahex
