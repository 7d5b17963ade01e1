#pragma once

namespace seahex
{

/// An sRGB colour, components 0 to 1.
struct Colour
{
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
};

/// `top` laid over `bottom` with the given opacity.
Colour blend(const Colour &bottom, const Colour &top, double opacity);

/// The colours of a picture. Water, shoal and land follow paper charts; the route, the tint of blocked cells and the
/// scale of expansion stay apart in lightness for eyes that don't tell red from green.
namespace palette
{

inline constexpr Colour paper{1.0, 1.0, 1.0};
inline constexpr Colour ink{0.13, 0.15, 0.19};
inline constexpr Colour water{0.965, 0.982, 0.992};
inline constexpr Colour shoal{0.72, 0.86, 0.95};
inline constexpr Colour shoalEdge{0.36, 0.60, 0.78};
inline constexpr Colour land{0.94, 0.86, 0.64};
inline constexpr Colour landEdge{0.47, 0.38, 0.18};
inline constexpr Colour blocked{0.55, 0.16, 0.20};
inline constexpr double blockedOpacity = 0.30;
inline constexpr double blockedEdgeOpacity = 0.75;  ///< outlines of blocked cells, and pixels on the rim of an image
inline constexpr Colour route{0.78, 0.0, 0.42};
inline constexpr Colour pathCell{0.96, 0.62, 0.79};

}  // namespace palette

/// Colour of a moment of the search: 0 is the first expansion, 1 the last (values beyond are clamped). Dark to light in
/// perceptually even steps.
Colour expansionColour(double moment);

}  // namespace seahex
