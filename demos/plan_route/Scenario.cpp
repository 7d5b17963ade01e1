#include "Scenario.h"

#include "Failure.h"

#include <cmath>
#include <filesystem>
#include <system_error>

namespace plan_route
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

std::string ownChart(const std::string &name)
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    for (const char *place : {"../maps", "../share/seahex/maps"})
    {
        const fs::path candidate = folder / place / name;
        if (fs::exists(candidate, ignored))
            return fs::weakly_canonical(candidate, ignored).string();
    }
    throw Failure(Exit::Chart, "the chart " + name + " is neither in the source tree nor in the install tree of this " +
                                   "program; name it with --chart");
}

}  // namespace plan_route
