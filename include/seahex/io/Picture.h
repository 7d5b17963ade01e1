#pragma once

#include <seahex/chart/Projection.h>
#include <seahex/geometry/CellLayout.h>
#include <seahex/geometry/Shape.h>
#include <seahex/world/Occupancy.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace seahex
{

/// Thrown when a picture can't be drawn or written.
class PictureError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// Everything that one picture shows, as plain values of the projection's plane.
///
/// Write `PictureContent content{projection, occupancy};` and fill in what there is; whatever stays empty is neither
/// drawn nor named in the legend. The pointed-to shapes are not owned and must outlive the drawing.
///
/// Points that are not finite are left out of the drawing.
struct PictureContent
{
    Projection projection;                       ///< the frame of all that follows; gives graticule and scale bar
    std::shared_ptr<const Occupancy> occupancy;  ///< of hexagons or of squares; never null

    std::vector<const Shape *> land = {};     ///< areas, lines and points of land
    std::vector<const Shape *> shoals = {};   ///< areas too shallow for the vessel
    std::vector<const Shape *> dangers = {};  ///< whatever else blocks: crosses at points, lines, dashed outlines

    /// Cells in the order in which a search expanded them, by their index in occupancy->layout(). Of a cell named twice
    /// the first time counts; indices outside the rectangle are passed over.
    std::vector<CellIndex> expanded = {};

    /// Cells to mark as the path's, as those at its waypoints or all that it touches. In no order; indices as above.
    std::vector<CellIndex> pathCells = {};

    LineString rawPath = {};                            ///< the planner's path, drawn thin
    LineString route = {};                              ///< the smoothed route, drawn strong
    std::string rawPathName = "path before smoothing";  ///< in the legend, one line, UTF-8
    std::string routeName = "route";                    ///< likewise; a long name is set smaller
    std::optional<Point> start = std::nullopt;
    std::optional<Point> goal = std::nullopt;

    std::string title = {};   ///< lines parted by '\n', the first is set larger; UTF-8
    std::string footer = {};  ///< one line below, as "not for navigation"; UTF-8

    std::optional<Box> crop = std::nullopt;  ///< part of the plane to show; by default the lattice's bounds
    int widthPx = 1600;                      ///< 400 to 8000; pixels of a PNG, user units of an SVG
};

/// Draws the picture into a .svg or .png file (by extension, in either case), north up.
///
/// Deep water is pale, shoals are light blue, land is buff, as on paper charts. Blocked cells lie over the water as a
/// translucent tint that ends at the coast, so that what the any-touch rule takes away shows; everything outside the
/// lattice is blocked and is tinted too. Graticule lines run through the projection and bend as it bends.
///
/// Up to about 60,000 cells in view are drawn as outlines. More are painted as one image (embedded in an
/// SVG) with a pixel tinted if its centre lies in a blocked cell or a blocked cell's centre lies in it: single cells
/// far smaller than a pixel stay visible, and cells never cost more than their number. The path's cells are outlines in
/// either case.
///
/// The file appears complete or not at all: it is written beside its place and renamed.
///
/// @throws PictureError if the extension is neither, the file can't be written, the occupancy is null, the crop box is
///         empty or not finite, or the width is out of range
void writePicture(const std::string &path, const PictureContent &content);

}  // namespace seahex
