#pragma once

#include <seahex/chart/Projection.h>
#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/Shape.h>

#include <string>
#include <vector>

namespace seahex
{

/// A meridian or parallel in the plane.
struct GraticuleLine
{
    long number = 0;  ///< value in steps, so that lines next to each other differ by 1
    double degrees =
        0.0;          ///< longitude or latitude; longitudes may run past 180 where the box crosses the antimeridian
    LineString line;  ///< its image, at least as far as it crosses the box
};

/// Ranges of longitude and latitude that a box of the plane covers. Longitudes run on past 180 rather than jump.
struct GraticuleExtent
{
    double westDeg = 0.0;
    double southDeg = 0.0;
    double eastDeg = 0.0;
    double northDeg = 0.0;
};

/// The extent of the box, from points along its border (a pole inside the box is not noticed). Points that are no image
/// of a position are passed over; an extent of zero size means that there were none.
GraticuleExtent graticuleExtent(const Projection &projection, const Box &box);

/// The smallest customary step, in degrees, of which at most `maxLines` fit into the span: 1, 2, 5 times powers of ten
/// below 10 minutes, then 10, 15, 20, 30 minutes, 1, 2, 5, 10, 15 and 30 degrees; 30 degrees if none fits.
double graticuleStepDeg(double spanDeg, double maxLines);

/// The step of the small ticks between lines that are `stepDeg` apart: a half to a fifth of it, on customary values.
double graticuleTickDeg(double stepDeg);

/// The meridians at the multiples of the step, each one an image of a straight longitude-latitude line.
/// @param toleranceM  how far, in metres, the images may leave the true lines; > 0
std::vector<GraticuleLine> meridians(const Projection &projection, const GraticuleExtent &extent, double stepDeg,
                                     double toleranceM);

/// The parallels, likewise.
std::vector<GraticuleLine> parallels(const Projection &projection, const GraticuleExtent &extent, double stepDeg,
                                     double toleranceM);

/// "21°38.5′N": degrees and minutes, with as many decimals as the step needs; whole degrees where the step has no
/// minutes.
std::string latitudeLabel(double degrees, double stepDeg);

/// "112°30′E", likewise; longitudes are brought into (-180, 180].
std::string longitudeLabel(double degrees, double stepDeg);

}  // namespace seahex
