#include "PictureBorder.h"

#include "PicturePath.h"

#include "seahex/io/Graticule.h"

#include <cmath>
#include <optional>

namespace seahex
{

namespace
{

constexpr double meridianSpacing = 170.0;  // least distance of lines, room for a label
constexpr double parallelSpacing = 110.0;
constexpr double borderGap = 2.0;
constexpr double borderWidth = 7.0;

struct Steps
{
    GraticuleExtent extent;
    double longitudeDeg = 30.0;
    double latitudeDeg = 30.0;
    double toleranceM = 1.0;
};

Steps chooseSteps(const PictureFrame &frame, const Projection &projection)
{
    Steps steps;
    steps.extent = graticuleExtent(projection, frame.plane);
    const Point size = (frame.map.max - frame.map.min) / frame.unit;
    steps.longitudeDeg = graticuleStepDeg(steps.extent.eastDeg - steps.extent.westDeg, size.x() / meridianSpacing);
    steps.latitudeDeg = graticuleStepDeg(steps.extent.northDeg - steps.extent.southDeg, size.y() / parallelSpacing);
    steps.toleranceM = 0.2 * frame.metresPerPx;
    return steps;
}

// Where a line of the graticule meets a side of the map: the coordinate along the side, in the plane.
std::optional<double> crossing(const LineString &line, int axis, double bound)
{
    for (std::size_t i = 1; i < line.size(); ++i)
    {
        const double a = line[i - 1][axis] - bound;
        const double b = line[i][axis] - bound;
        if ((a <= 0.0) == (b <= 0.0))
            continue;
        return line[i - 1][1 - axis] + (line[i][1 - axis] - line[i - 1][1 - axis]) * a / (a - b);
    }
    return std::nullopt;
}

// A side of the map: `axis` is constant along it, at `bound` in the plane.
struct Side
{
    int axis;
    double bound;
    double outward;  // on the page, across the side: -1 left and up, 1 right and down
};

struct Tick
{
    long number;
    double page;  // along the side
    double degrees;
};

std::vector<Tick> ticksAlong(const PictureFrame &frame, const std::vector<GraticuleLine> &lines, const Side &side)
{
    std::vector<Tick> ticks;
    const int along = 1 - side.axis;
    for (const GraticuleLine &line : lines)
    {
        const std::optional<double> at = crossing(line.line, side.axis, side.bound);
        if (!at || *at < frame.plane.min[along] || *at > frame.plane.max[along])
            continue;
        Point p = frame.plane.min;
        p[along] = *at;
        ticks.push_back({line.number, frame.toPage(p)[along], line.degrees});
    }
    return ticks;
}

// Fills every other stretch between ticks with ink.
void drawBars(PictureCanvas &canvas, const std::vector<Tick> &ticks, const Side &side)
{
    if (ticks.empty())
        return;
    const PictureFrame &frame = canvas.frame();
    const int along = 1 - side.axis;
    const double edge = side.outward < 0.0 ? frame.map.min[side.axis] : frame.map.max[side.axis];
    const double inner = edge + side.outward * canvas.units(borderGap);
    const double outer = inner + side.outward * canvas.units(borderWidth);
    const bool rising = ticks.front().page <= ticks.back().page;  // latitudes rise against the page's y
    const auto bar = [&](double from, double to)
    {
        Box box;
        box.min[side.axis] = std::min(inner, outer);
        box.max[side.axis] = std::max(inner, outer);
        box.min[along] = std::min(from, to);
        box.max[along] = std::max(from, to);
        canvas.rectangle(box);
    };
    if (ticks.front().number % 2 != 0)
        bar(rising ? frame.map.min[along] : frame.map.max[along], ticks.front().page);
    for (std::size_t i = 0; i < ticks.size(); ++i)
        if (ticks[i].number % 2 == 0)
            bar(ticks[i].page, i + 1 < ticks.size() ? ticks[i + 1].page
                               : rising             ? frame.map.max[along]
                                                    : frame.map.min[along]);
    canvas.fill(palette::ink);
    cairo_new_path(canvas.cairo());
}

void drawFrameLines(PictureCanvas &canvas)
{
    for (const double gap : {0.0, borderGap, borderGap + borderWidth})
    {
        Box box = canvas.frame().map;
        box.min -= Point::Constant(canvas.units(gap));
        box.max += Point::Constant(canvas.units(gap));
        canvas.rectangle(box);
        canvas.stroke(palette::ink, 1.0);
    }
}

}  // namespace

void drawGraticule(PictureCanvas &canvas, const Projection &projection)
{
    const Steps steps = chooseSteps(canvas.frame(), projection);
    PicturePath path(canvas);
    for (const GraticuleLine &line : meridians(projection, steps.extent, steps.longitudeDeg, steps.toleranceM))
        path.addLine(line.line);
    for (const GraticuleLine &line : parallels(projection, steps.extent, steps.latitudeDeg, steps.toleranceM))
        path.addLine(line.line);
    canvas.stroke(palette::ink, 0.8, 0.45);
}

void drawBorder(PictureCanvas &canvas, const Projection &projection)
{
    const PictureFrame &frame = canvas.frame();
    const Steps steps = chooseSteps(frame, projection);
    const auto east = [&](double step)
    {
        return meridians(projection, steps.extent, step, steps.toleranceM);
    };
    const auto north = [&](double step)
    {
        return parallels(projection, steps.extent, step, steps.toleranceM);
    };
    const auto smallMeridians = east(graticuleTickDeg(steps.longitudeDeg));
    const auto smallParallels = north(graticuleTickDeg(steps.latitudeDeg));
    const Side upper{1, frame.plane.max.y(), -1.0};
    const Side lower{1, frame.plane.min.y(), 1.0};
    const Side left{0, frame.plane.min.x(), -1.0};
    const Side right{0, frame.plane.max.x(), 1.0};
    for (const Side &side : {upper, lower})
        drawBars(canvas, ticksAlong(frame, smallMeridians, side), side);
    for (const Side &side : {left, right})
        drawBars(canvas, ticksAlong(frame, smallParallels, side), side);
    drawFrameLines(canvas);

    const TextStyle below{15.0, false, false, 0.5, palette::ink};
    for (const Tick &tick : ticksAlong(frame, east(steps.longitudeDeg), lower))
        canvas.text({tick.page, frame.map.max.y() + canvas.units(borderGap + borderWidth + 19.0)},
                    longitudeLabel(tick.degrees, steps.longitudeDeg), below);
    const TextStyle beside{15.0, false, false, 1.0, palette::ink};
    for (const Tick &tick : ticksAlong(frame, north(steps.latitudeDeg), left))
        canvas.text({frame.map.min.x() - canvas.units(borderGap + borderWidth + 7.0), tick.page + canvas.units(5.3)},
                    latitudeLabel(tick.degrees, steps.latitudeDeg), beside);
}

}  // namespace seahex
