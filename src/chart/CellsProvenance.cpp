#include "seahex/chart/CellsProvenance.h"

#include "CodeDigest.h"
#include "Digest.h"

#include "seahex/chart/ChartError.h"

#include <boost/version.hpp>
#include <ogr_srs_api.h>

#include <array>
#include <fstream>
#include <sstream>

namespace seahex
{
namespace
{

namespace fs = std::filesystem;

/// A number as it can be read back without loss.
std::string exactly(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

std::string programLine()
{
    int major = 0;
    int minor = 0;
    int patch = 0;
    OSRGetPROJVersion(&major, &minor, &patch);
    std::ostringstream line;
    line << "program seahex " << PROGRAM_VERSION << ", code " << CODE_DIGEST << ", PROJ " << major << "." << minor
         << "." << patch << ", Boost " << BOOST_LIB_VERSION << "\n";
    return line.str();
}

std::string fileLine(const fs::path &path)
{
    std::ifstream in(path, std::ios::binary);
    std::array<char, 1 << 16> block;
    Digest digest;
    std::uint64_t size = 0;
    while (in.good())
    {
        in.read(block.data(), block.size());
        const auto count = static_cast<std::size_t>(in.gcount());
        digest.add(block.data(), count);
        size += count;
    }
    if (!in.eof() || in.bad())
        throw ChartUnreadable("'" + path.string() +
                              "' can't be read again, so that what the cells are made of can't be told");
    return "file " + path.filename().string() + ", " + std::to_string(size) + " bytes, digest " + digest.text() + "\n";
}

std::string vesselLine(const Vessel &vessel)
{
    // This does not compile when the vessel gets another property, which must then be named below.
    const auto &[draughtM, underKeelClearanceM, airDraughtM, beamM, marginM] = vessel;
    return "vessel draught " + exactly(draughtM) + ", under-keel clearance " + exactly(underKeelClearanceM) +
           ", air draught " + exactly(airDraughtM) + ", beam " + exactly(beamM) + ", margin " + exactly(marginM) + "\n";
}

const char *nameOf(HazardScope scope)
{
    switch (scope)
    {
        case HazardScope::All:
            return "all";
        case HazardScope::LandOnly:
            return "land only";
        case HazardScope::WaterColumn:
            return "water column";
        case HazardScope::WaterColumnAboveCables:
            return "water column above cables";
    }
    return "unknown";
}

std::string latticeLine(const Lattice &lattice)
{
    std::ostringstream line;
    line << "lattice of " << (lattice.hexagons() != nullptr ? "hexagons" : "squares") << " from "
         << exactly(lattice.northWest().x()) << " " << exactly(lattice.northWest().y()) << ", pitch "
         << exactly(lattice.pitch()) << ", " << lattice.columns() << " columns, " << lattice.rows() << " rows\n";
    return line.str();
}

/// The number of points goes before them, so that no point can move from one line to the next unseen.
template <class Points>
void addPoints(Digest &digest, const Points &points)
{
    digest.add(std::uint64_t{points.size()});
    for (const Point &p : points)
    {
        digest.add(p.x());
        digest.add(p.y());
    }
}

void addShape(Digest &digest, const Shape &shape)
{
    addPoints(digest, shape.points);
    digest.add(std::uint64_t{shape.lines.size()});
    for (const LineString &line : shape.lines)
        addPoints(digest, line);
    digest.add(std::uint64_t{shape.areas.size()});
    for (const Polygon &area : shape.areas)
    {
        addPoints(digest, area.outer());
        digest.add(std::uint64_t{area.inners().size()});
        for (const Ring &hole : area.inners())
            addPoints(digest, hole);
    }
}

std::string blockingLine(const Chart &chart, const Vessel &vessel, HazardScope scope)
{
    Digest digest;
    std::size_t count = 0;
    for (const GeoHazard &hazard : chart.hazards)
    {
        if (!judge(*hazard.object, vessel, scope).blocks())
            continue;
        ++count;
        digest.add(keepOutRadiusM(*hazard.object, vessel));
        addShape(digest, hazard.shape.lonLat);
    }
    addShape(digest, chart.coverage.lonLat);
    return "blocking " + std::to_string(count) + " objects in their coverage, digest " + digest.text() + "\n";
}

}  // namespace

std::string cellsProvenance(const Chart &chart, const Vessel &vessel, HazardScope scope, const Projection &projection,
                            const Lattice &lattice)
{
    std::string text = programLine();
    for (const CellReport &cell : chart.cells)
        for (const fs::path &file : cell.files)
            text += fileLine(file);
    text += vesselLine(vessel);
    text += std::string("scope ") + nameOf(scope) + "\n";
    text += blockingLine(chart, vessel, scope);
    text += "projection " + projection.definition() + "\n";
    text += latticeLine(lattice);
    return text;
}

}  // namespace seahex
