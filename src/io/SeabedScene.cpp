#include "SeabedScene.h"

#include "PictureTitle.h"

#include "seahex/io/Picture.h"
#include "seahex/io/ScaleBar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace seahex
{
namespace
{

constexpr double mostAcross = 160.0;  // faces
constexpr double reliefShare = 0.25;  // of the width
constexpr double degree = M_PI / 180.0;

bool isFinite(const Point3 &p)
{
    return p.allFinite();
}

Colour scaled(const Colour &colour, double factor)
{
    const auto by = [factor](double component)
    {
        return std::min(component * factor, 1.0);
    };
    return {by(colour.red), by(colour.green), by(colour.blue)};
}

}  // namespace

Colour seabedColour(double share)
{
    static constexpr std::array<Colour, 5> water{
        {{0.85, 0.95, 0.97}, {0.56, 0.80, 0.90}, {0.27, 0.58, 0.78}, {0.13, 0.36, 0.62}, {0.06, 0.17, 0.40}}};
    if (share < 0.0)
        return blend(palette::land, palette::landEdge, 0.6 * std::min(-share, 1.0));
    const double place = std::min(share, 1.0) * (water.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), water.size() - 2);
    return blend(water[below], water[below + 1], place - static_cast<double>(below));
}

SeabedScene::SeabedScene(const SeabedPictureContent &content, const Point &corner, double width) : content_(content)
{
    box_ = content.seabed->grid().bounds();
    if (content.crop)
        box_ = {box_.min.cwiseMax(content.crop->min), box_.max.cwiseMin(content.crop->max)};
    if (!(box_.max.x() > box_.min.x()) || !(box_.max.y() > box_.min.y()))
        throw PictureError("no seabed is in view");
    gather();
    layOut(corner, width);
    gatherFaces();
    gatherDives();
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [](const Piece &a, const Piece &b) { return a.distance > b.distance; });
}

void SeabedScene::gather()
{
    const Point extent = box_.max - box_.min;
    const Point spacing = content_.seabed->grid().spacing();
    const double coarsest = extent.maxCoeff() / mostAcross;
    const auto count = [coarsest](double length, double step)
    {
        return 1 + static_cast<std::size_t>(std::max(std::ceil(length / std::max(step, coarsest) - 1e-9), 1.0));
    };
    columns_ = count(extent.x(), spacing.x());
    rows_ = count(extent.y(), spacing.y());
    shoalest_ = std::numeric_limits<double>::infinity();
    deepest_ = -shoalest_;
    for (std::size_t row = 0; row < rows_; ++row)
        for (std::size_t column = 0; column < columns_; ++column)
        {
            const Point share(static_cast<double>(column) / static_cast<double>(columns_ - 1),
                              static_cast<double>(row) / static_cast<double>(rows_ - 1));
            const Point p = (box_.min + extent.cwiseProduct(share)).cwiseMin(box_.max);
            const double depth = content_.seabed->depthAt(p);
            nodes_.emplace_back(p.x(), p.y(), depth);
            if (!std::isfinite(depth))
                continue;
            shoalest_ = std::min(shoalest_, depth);
            deepest_ = std::max(deepest_, depth);
        }
    if (!(deepest_ >= shoalest_))
        throw PictureError("no known seabed is in view");
}

void SeabedScene::layOut(const Point &corner, double width)
{
    const double relief = std::max({deepest_ - shoalest_, deepest_, 1e-9});
    exaggeration_ =
        content_.exaggeration > 0.0 ? content_.exaggeration : reliefShare * (box_.max - box_.min).maxCoeff() / relief;
    // right, up and away of the observer: the plane turned by the azimuth, then tilted
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(content_.azimuthDeg * degree, Eigen::Vector3d::UnitZ()).matrix();
    const double sine = std::sin(content_.elevationDeg * degree);
    const double cosine = std::cos(content_.elevationDeg * degree);
    Eigen::Matrix3d tilt;
    tilt << 1.0, 0.0, 0.0, 0.0, sine, cosine, 0.0, cosine, -sine;
    view_ = tilt * turn;

    Point low = Point::Constant(std::numeric_limits<double>::infinity());
    Point high = -low;
    const auto include = [&](const Point3 &p)
    {
        if (!isFinite(p))
            return;
        low = low.cwiseMin(seen(p).head<2>());
        high = high.cwiseMax(seen(p).head<2>());
    };
    std::for_each(nodes_.begin(), nodes_.end(), include);
    for (const DiveLine &dive : content_.dives)
        std::for_each(dive.points.begin(), dive.points.end(), include);
    scale_ = width / std::max(high.x() - low.x(), 1e-12);
    shift_ = corner + Point(-low.x() * scale_, high.y() * scale_);
    bottom_ = corner.y() + (high.y() - low.y()) * scale_;
}

Point3 SeabedScene::seen(const Point3 &p) const
{
    return view_ * Point3(p.x() - box_.min.x(), p.y() - box_.min.y(), -p.z() * exaggeration_);
}

Point SeabedScene::onPage(const Point3 &p) const
{
    const Point3 s = seen(p);
    return shift_ + scale_ * Point(s.x(), -s.y());
}

void SeabedScene::gatherFaces()
{
    for (std::size_t row = 0; row + 1 < rows_; ++row)
        for (std::size_t column = 0; column + 1 < columns_; ++column)
        {
            const std::size_t node = row * columns_ + column;
            Point3 middle = Point3::Zero();
            bool isKnown = true;
            for (const std::size_t corner : {node, node + 1, node + columns_ + 1, node + columns_})
            {
                isKnown = isKnown && isFinite(nodes_[corner]);
                middle += 0.25 * nodes_[corner];
            }
            // Faces of a height field hide each other by their places on the plane alone.
            if (isKnown)
                pieces_.push_back({seen({middle.x(), middle.y(), 0.0}).z(), node, -1});
        }
}

void SeabedScene::gatherDives()
{
    for (std::size_t i = 0; i < content_.dives.size(); ++i)
    {
        lines_.emplace_back();
        std::vector<Point3> points;
        std::copy_if(content_.dives[i].points.begin(), content_.dives[i].points.end(), std::back_inserter(points),
                     isFinite);
        for (std::size_t k = 1; k < points.size(); ++k)
            addLeg(static_cast<int>(i), points[k - 1], points[k]);
    }
}

void SeabedScene::addLeg(int dive, const Point3 &a, const Point3 &b)
{
    std::vector<Point3> &line = lines_[static_cast<std::size_t>(dive)];
    const Point extent = box_.max - box_.min;
    const double face =
        std::max(extent.x() / static_cast<double>(columns_ - 1), extent.y() / static_cast<double>(rows_ - 1));
    const int count = 1 + static_cast<int>(std::min(horizontal(Point3(b - a)).norm() / (0.5 * face), 1e4));
    if (line.empty())
        line.push_back(a);
    for (int i = 1; i <= count; ++i)
    {
        line.push_back(a + (b - a) * (static_cast<double>(i) / count));
        const Point3 middle = 0.5 * (line[line.size() - 2] + line.back());
        // A face's width nearer: the dive lies above the face that it crosses, and must not be hidden by it.
        pieces_.push_back({seen({middle.x(), middle.y(), 0.0}).z() - face, line.size() - 2, dive});
    }
}

Colour SeabedScene::tintOf(double depth) const
{
    return depth >= 0.0 ? seabedColour(deepest_ > 0.0 ? depth / deepest_ : 0.0)
                        : seabedColour(-std::max(depth / shoalest_, 0.02));
}

void SeabedScene::drawFace(PictureCanvas &canvas, std::size_t node) const
{
    const std::array<std::size_t, 4> corners{node, node + 1, node + columns_ + 1, node + columns_};
    double depth = 0.0;
    for (const std::size_t corner : corners)
    {
        const Point page = onPage(nodes_[corner]);
        cairo_line_to(canvas.cairo(), page.x(), page.y());
        depth += 0.25 * nodes_[corner].z();
    }
    cairo_close_path(canvas.cairo());
    const auto raised = [this](const Point3 &p)
    {
        return Point3(p.x(), p.y(), -p.z() * exaggeration_);
    };
    const Point3 normal = (raised(nodes_[corners[2]]) - raised(nodes_[corners[0]]))
                              .cross(raised(nodes_[corners[3]]) - raised(nodes_[corners[1]]))
                              .normalized();
    const Point3 light = Point3(-0.5, 0.35, 0.8).normalized();  // from the north-west, as on maps
    const Colour colour = scaled(tintOf(depth), 0.62 + 0.46 * std::max(normal.dot(light), 0.0));
    canvas.fill(colour);
    canvas.stroke(colour, 0.5);  // closes the seams between faces
}

void SeabedScene::drawLine(PictureCanvas &canvas, const Point3 &a, const Point3 &b, const Colour &colour, double width,
                           double opacity) const
{
    const Point from = onPage(a);
    const Point to = onPage(b);
    cairo_move_to(canvas.cairo(), from.x(), from.y());
    cairo_line_to(canvas.cairo(), to.x(), to.y());
    canvas.stroke(colour, width, opacity);
}

Point3 SeabedScene::below(const Point3 &p) const
{
    return {p.x(), p.y(), content_.seabed->depthAt(horizontal(p))};
}

/// A piece of a dive, and its track on the seabed.
void SeabedScene::drawDive(PictureCanvas &canvas, const Piece &piece) const
{
    const auto dive = static_cast<std::size_t>(piece.dive);
    const Point3 &a = lines_[dive][piece.place];
    const Point3 &b = lines_[dive][piece.place + 1];
    if (isFinite(below(a)) && isFinite(below(b)))
        drawLine(canvas, below(a), below(b), palette::ink, 1.4, 0.6);
    drawLine(canvas, a, b, content_.dives[dive].colour, 3.2, 1.0);
}

void SeabedScene::drawPlumbLines(PictureCanvas &canvas) const
{
    constexpr std::size_t mostPlumbed = 60;
    for (const DiveLine &dive : content_.dives)
        if (dive.points.size() <= mostPlumbed)
            for (const Point3 &p : dive.points)
                if (isFinite(p) && isFinite(below(p)))
                    drawLine(canvas, p, below(p), dive.colour, 0.9, 0.45);
}

void SeabedScene::drawPale(PictureCanvas &canvas) const
{
    for (std::size_t i = 0; i < lines_.size(); ++i)
        for (std::size_t k = 1; k < lines_[i].size(); ++k)
            drawLine(canvas, lines_[i][k - 1], lines_[i][k], content_.dives[i].colour, 2.0, 0.25);
}

void SeabedScene::drawEnds(PictureCanvas &canvas) const
{
    for (std::size_t i = 0; i < lines_.size(); ++i)
    {
        if (lines_[i].empty())
            continue;
        for (const Point3 &end : {lines_[i].front(), lines_[i].back()})
        {
            const Point page = onPage(end);
            cairo_new_path(canvas.cairo());
            cairo_arc(canvas.cairo(), page.x(), page.y(), canvas.units(6.0), 0.0, 2.0 * M_PI);
            canvas.fill(content_.dives[i].colour);
            canvas.stroke(palette::paper, 1.5);
        }
    }
}

void SeabedScene::draw(PictureCanvas &canvas) const
{
    for (const Piece &piece : pieces_)
        if (piece.dive < 0)
            drawFace(canvas, piece.place);
        else
            drawDive(canvas, piece);
    drawPlumbLines(canvas);
    drawPale(canvas);
    drawEnds(canvas);
}

void SeabedScene::drawLegend(PictureCanvas &canvas) const
{
    const TextStyle small{14.0, false, false, 0.0, palette::ink};
    TextStyle centred = small;
    centred.align = 0.5;
    const double top = bottom_ + canvas.units(34.0);
    const double barWidth = canvas.units(300.0);
    double x = canvas.units(pictureLeft);
    constexpr int steps = 60;
    for (int i = 0; i < steps; ++i)
    {
        const double at = x + barWidth * i / steps;
        canvas.rectangle({{at, top}, {at + barWidth / steps + 0.5, top + canvas.units(14.0)}});
        canvas.fill(tintOf(std::max(deepest_, 0.0) * (i + 0.5) / steps));
        cairo_new_path(canvas.cairo());
    }
    canvas.text({x, top + canvas.units(32.0)}, "0", centred);
    canvas.text({x + barWidth, top + canvas.units(32.0)}, plainNumber(std::max(deepest_, 0.0), 0) + " " + content_.unit,
                centred);
    canvas.text({x + 0.5 * barWidth, top + canvas.units(32.0)}, "depth", centred);
    x += barWidth + canvas.units(60.0);
    for (const DiveLine &dive : content_.dives)
    {
        cairo_move_to(canvas.cairo(), x, top + canvas.units(8.0));
        cairo_line_to(canvas.cairo(), x + canvas.units(34.0), top + canvas.units(8.0));
        canvas.stroke(dive.colour, 3.2);
        canvas.text({x + canvas.units(44.0), top + canvas.units(13.0)}, dive.name, small);
        x += canvas.units(76.0) + canvas.textWidth(dive.name, small);
    }
    TextStyle right = small;
    right.align = 1.0;
    canvas.text({canvas.units(pictureRight), top + canvas.units(13.0)},
                "heights " + plainNumber(exaggeration_, exaggeration_ < 10.0 ? 1 : 0) + " times; seen towards " +
                    plainNumber(std::fmod(content_.azimuthDeg + 360.0, 360.0), 0) + " degrees",
                right);
    canvas.text({canvas.units(pictureRight), top + canvas.units(32.0)}, content_.footer, right);
}

}  // namespace seahex
