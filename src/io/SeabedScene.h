#pragma once

#include "PictureCanvas.h"

#include "seahex/io/SeabedPicture.h"

#include <Eigen/Geometry>

#include <vector>

namespace seahex
{

/// Colour of a depth, as a share of the greatest: pale at the surface, dark at 1; land below 0, as a share of the
/// highest.
Colour seabedColour(double share);

/// What a picture of the seabed holds, laid out on the page: faces of the seabed and pieces of dives, drawn from the
/// farthest to the nearest.
class SeabedScene
{
public:
    /// @param corner  upper left of the scene on the page
    /// @throws PictureError if no known seabed is in view
    SeabedScene(const SeabedPictureContent &content, const Point &corner, double width);

    /// Where it ends on the page.
    double bottom() const { return bottom_; }

    void draw(PictureCanvas &canvas) const;
    void drawLegend(PictureCanvas &canvas) const;

private:
    /// A quadrilateral of the seabed, or a piece of a dive.
    struct Piece
    {
        double distance;    // from the observer; the greater is drawn first
        std::size_t place;  // of its first corner among the nodes, or of its first point in its dive
        int dive;           // -1: seabed
    };

    void gather();
    void layOut(const Point &corner, double width);
    void gatherFaces();
    void gatherDives();
    void addLeg(int dive, const Point3 &a, const Point3 &b);
    Point3 seen(const Point3 &p) const;  // right, up, away
    Point onPage(const Point3 &p) const;
    void drawFace(PictureCanvas &canvas, std::size_t node) const;
    void drawLine(PictureCanvas &canvas, const Point3 &a, const Point3 &b, const Colour &colour, double width,
                  double opacity) const;
    Point3 below(const Point3 &p) const;
    void drawDive(PictureCanvas &canvas, const Piece &piece) const;
    void drawPlumbLines(PictureCanvas &canvas) const;
    void drawPale(PictureCanvas &canvas) const;
    void drawEnds(PictureCanvas &canvas) const;
    Colour tintOf(double depth) const;

    const SeabedPictureContent &content_;
    Box box_;
    std::size_t columns_ = 0;  // of the nodes drawn, row by row from the south-west
    std::size_t rows_ = 0;
    std::vector<Point3> nodes_;  // z is the depth; not finite where unknown
    double shoalest_ = 0.0;
    double deepest_ = 0.0;
    double exaggeration_ = 1.0;
    Eigen::Matrix3d view_;
    double scale_ = 1.0;
    Point shift_ = Point::Zero();
    double bottom_ = 0.0;
    std::vector<std::vector<Point3>> lines_;  // the dives, cut into short pieces
    std::vector<Piece> pieces_;
};

}  // namespace seahex
