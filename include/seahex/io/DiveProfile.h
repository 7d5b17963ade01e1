#pragma once

#include <limits>
#include <string>
#include <vector>

namespace seahex
{

/// A place on the vertical section along a dive.
struct ProfilePoint
{
    double distanceM = 0.0;  ///< from the start, along the track over the ground
    double depthM = 0.0;     ///< positive down
};

/// What the picture of a dive's vertical section shows. Distances never fall along path and seabed.
struct DiveProfileContent
{
    std::vector<ProfilePoint> path;    ///< waypoints, at least two; marked one by one while there is room for it
    std::vector<ProfilePoint> seabed;  ///< below the track, at least two
    double clearanceM = 0.0;           ///< least water above the seabed: drawn as a line that runs along it
    double ceilingM = 0.0;             ///< least depth
    double deepestM = std::numeric_limits<double>::infinity();  ///< greatest depth; infinite: none is drawn

    std::string title = {};   ///< lines parted by '\n', the first is set larger; UTF-8
    std::string footer = {};  ///< one line below; UTF-8
    int widthPx = 1600;       ///< 400 to 8000; the height is half of that
};

/// Draws a dive's vertical section, from the surface down, into a .svg or .png file (by extension, in either case).
/// Depths are drawn larger than distances; both have their scale. Points that are not finite are left out.
///
/// The file appears complete or not at all: it is written beside its place and renamed.
///
/// @throws PictureError if the extension is neither, the file can't be written, path or seabed have fewer than two
///         points, or the width is out of range
void writeDiveProfile(const std::string &path, const DiveProfileContent &content);

}  // namespace seahex
