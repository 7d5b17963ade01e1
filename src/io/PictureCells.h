#pragma once

#include "CellOutline.h"
#include "PictureCanvas.h"

#include <functional>

namespace seahex
{

/// The cells of a picture: as outlines where few are in view, as an image of the map's pixels otherwise.
class PictureCells
{
public:
    /// The canvas and the content must outlive this object.
    PictureCells(PictureCanvas &canvas, const PictureContent &content);

    /// The expanded cells, opaque, coloured by order.
    void drawExpanded();

    /// The blocked cells as a tint, and the same tint over everything outside the lattice. To be drawn before the land,
    /// which is blocked anyway and keeps its colour.
    void drawBlocked();

    /// The path's cells, opaque, in a light shade of the route's colour.
    void drawPathCells();

    /// Faint edges of all cells, if these are large enough on the page to be told apart.
    void drawGrid();

private:
    bool asOutlines() const;
    template <class Corners>
    void addLoop(const Corners &corners);
    void addOutlineOf(const std::function<bool(OffsetCoord)> &inside);
    bool isInView(OffsetCoord cell) const;
    void outlineExpanded();
    void paintExpanded();
    Box latticeOnPage() const;
    void drawOutside();

    PictureCanvas &canvas_;
    const PictureContent &content_;
    const Occupancy &occupancy_;
    const Lattice &lattice_;
    CellWindow window_;
};

/// Fills and strokes the current path as cells of the path; the legend's sample too.
void strokePathCells(PictureCanvas &canvas);

}  // namespace seahex
