#pragma once

#include <seahex/geometry/GeoPoint.h>

#include <string>

namespace seahex
{

/// Reads a position as people write it.
///
/// Latitude first; decimal degrees, degrees and minutes, or degrees, minutes and seconds, where only the last number
/// may have decimals; signs or hemisphere letters, but not both on one value:
///
///     21.635,112.521                   21.635 112.521                 -33.85, 151.2
///     21 38.1N, 112 31.26E             42 20.5 N 70 53.2 W            N42 20.5 W70 53.2
///     21°38'06"N 112°31'15.6"E         42-20.5N 070-53.2W             21:38:06N 112:31:15.6E
///
/// Letters win over order: "112.521E,21.635N" is the same position as the first one. A comma always parts the two
/// values and is never a decimal one. Without a comma, a letter, or degree signs, a blank may occur only between the
/// values: four bare numbers are refused rather than paired off. Degree, minute and second signs may be the typographic
/// ones, in UTF-8.
///
/// Longitudes from -180 to 360 are accepted and brought into [-180, 180). Decimal degrees are read to the nearest
/// double; the program's locale has no influence.
///
/// @throws PositionError with a sentence that quotes the text, for whatever else it may be
GeoPoint parsePosition(const std::string &text);

}  // namespace seahex
