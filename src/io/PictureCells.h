#pragma once

#include "CellOutline.h"
#include "PictureCanvas.h"

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

    /// Faint edges of all cells, if these are large enough on the page to be told apart.
    void drawGrid();

private:
    bool asOutlines() const;
    void addLoops(const std::vector<std::vector<CellCorner>> &loops);
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

}  // namespace seahex
