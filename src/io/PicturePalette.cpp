#include "seahex/io/PicturePalette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace seahex
{

Colour blend(const Colour &bottom, const Colour &top, double opacity)
{
    const auto mix = [opacity](double b, double t)
    {
        return b + (t - b) * opacity;
    };
    return {mix(bottom.red, top.red), mix(bottom.green, top.green), mix(bottom.blue, top.blue)};
}

Colour expansionColour(double moment)
{
    // Nine stops of "viridis" (N. Smith and S. van der Walt, in the public domain by CC0), whose lightness rises
    // evenly.
    static constexpr std::array<Colour, 9> stops{{{0.267, 0.005, 0.329},
                                                  {0.279, 0.175, 0.483},
                                                  {0.230, 0.322, 0.546},
                                                  {0.173, 0.449, 0.558},
                                                  {0.128, 0.567, 0.551},
                                                  {0.158, 0.684, 0.502},
                                                  {0.369, 0.789, 0.383},
                                                  {0.678, 0.864, 0.190},
                                                  {0.993, 0.906, 0.144}}};
    const double place = (moment > 0.0 ? std::min(moment, 1.0) : 0.0) * (stops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    const Colour full = blend(stops[below], stops[below + 1], place - static_cast<double>(below));
    // Lightened, so that the route and the coast stay the strongest things in the picture.
    return blend(full, palette::paper, 0.55);
}

}  // namespace seahex
