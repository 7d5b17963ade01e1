#include "ChengScenario.h"

#include <cmath>

namespace demos
{

double cheng2020::publishedPitchDeg()
{
    return std::sqrt(3.0) * sideDeg;
}

seahex::HexLattice cheng2020::lattice(double pitchDeg)
{
    const double published = publishedPitchDeg();
    const seahex::Point corner(westDeg, northDeg);
    if (pitchDeg == 0.0)
        return seahex::HexLattice(corner, published, columns, rows);
    const double scale = published / pitchDeg;
    return seahex::HexLattice(corner, pitchDeg, static_cast<std::int64_t>(std::ceil(columns * scale)),
                              static_cast<std::int64_t>(std::ceil(rows * scale)));
}

}  // namespace demos
