#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace seahex::test
{

/// A position as (latitude, longitude), both in degrees, WGS-84.
using LatLon = std::pair<double, double>;

/// What the judge has to know of a vessel. Required depth: draught + under-keel clearance, no tide, no squat.
struct OracleVessel
{
    double draughtM;
    double underKeelClearanceM;
};

/// One reason why one leg is not allowed. Leg k runs from waypoint k to waypoint k + 1.
struct Violation
{
    std::size_t leg;
    /// For people: "leg 3 touches WRECKS 0226... (VALSOU 0.4 m)" or "leg 3 leaves the coverage".
    std::string what;
};

/// The blocking object nearest to a polyline.
struct NearestHazard
{
    /// Metres to the object's own geometry; 0 where a leg touches it; infinity where the chart blocks nothing.
    double distanceM;
    std::size_t leg;
    std::string what;
};

/// Shoelace sums, doubled, on the chart's integer grid (degrees times COMF, rounded).
struct GroupOneSums
{
    /// M_COVR with CATCOV 1.
    std::int64_t coverage;
    /// DEPARE, DRGARE, LNDARE, UNSARE, PONTON, FLODOC, HULKES.
    std::int64_t groupOne;
    /// 0 on a sound cell: group 1 tiles the coverage without gap or overlap.
    std::int64_t difference() const { return coverage - groupOne; }
};

/// An independent judge of routes: it derives from the OGR layers of a chart which water is forbidden and says which
/// legs of a route enter it. It shares no code with the library (not a single header of it): it reads through GDAL
/// and asks GEOS, in unprojected longitude and latitude, so an error of the library's reader, rules, projection or
/// lattice can't hide here as well.
///
/// A leg is the straight line in longitude and latitude between two waypoints, as the edges of the chart are.
/// A leg touches an area or a line if it shares at least one point with the closed geometry (an edge or a corner is
/// enough; GEOS' robust predicates, no tolerance), and a point if it passes within 1e-9 degrees of it (0.1 mm).
/// A leg leaves the coverage if any of it lies outside the closed union of M_COVR with CATCOV 1; a seam between two
/// of them with the same edge in both is inside.
///
/// Blocked are, for the required depth d:
/// - DEPARE and DRGARE with DRVAL1 < d or without DRVAL1; coverage in no group 1 area; soundings <= d;
/// - LNDARE, UNSARE, PONTON, HULKES, FLODOC, COALNE, SLCONS, CAUSWY, DAMCON, DYKCON, GATCON, DRYDOC, LOKBSN, PILPNT,
///   PYLONS, OFSPLF, FSHFAC, FORSTC, OILBAR, LOGPON, ICEARE, every buoy and beacon, LITFLT, LITVES, DAYMAR: always;
/// - MORFAC with CATMOR 1, 2, 3, 5, 7 or none; MARCUL unless VALSOU > d and WATLEV 3; PIPSOL with DRVAL1 <= d;
/// - OBSTRN, UWTROC, WRECKS with VALSOU <= d, with WATLEV 7, with CATOBS 8 or 10, and without VALSOU by the depth that
///   S-52's procedures OBSTRN04 and WRECKS02 put in its place.
/// Depths are compared as whole micrometres, so that 1.2 + 0.5 is 1.7.
///
/// Limits: no tide, no dates, no restricted areas, no air draught, one chart at a time, nothing across 180 degrees.
/// M_COVR whose common edge is slanted and has a vertex on one side only may leave a slit of one rounding error.
/// Not thread safe, not even its const functions: GEOS prepares its geometries at the first question.
class ChartOracle
{
public:
    /// Opens an S-57 cell with its updates, or any OGR source whose layers bear S-57 acronyms.
    /// \throws std::runtime_error if the source can't be opened or read, is not in degrees or has no coverage.
    ChartOracle(const std::string &chartPath, const OracleVessel &vessel);
    ~ChartOracle();
    ChartOracle(ChartOracle &&) noexcept;
    ChartOracle &operator=(ChartOracle &&) noexcept;
    ChartOracle(const ChartOracle &) = delete;
    ChartOracle &operator=(const ChartOracle &) = delete;

    /// Every leg with every blocking object that it touches, and every leg that leaves the coverage; ordered by leg,
    /// an object at most once per leg. A single waypoint counts as leg 0, without length.
    /// \throws std::runtime_error if a waypoint is not a position, or if GEOS fails (never a silent "no").
    std::vector<Violation> violations(const std::vector<LatLon> &route) const;

    /// The same, and stricter: objects that are points (soundings too) are touched within \a pointRadiusM metres,
    /// the radius included. The distance is exact to 0.1 % plus 1e-9 degrees up to radii of 1 km and latitude 75.
    std::vector<Violation> violationsWithin(const std::vector<LatLon> &route, double pointRadiusM) const;

    /// True if the position touches a blocking object or lies outside the coverage.
    bool blocked(double latitudeDeg, double longitudeDeg) const;

    /// DRVAL1 of the depth area (DEPARE, DRGARE) that contains the position, edges included; the least if several do.
    /// Empty if none contains it or one of them has no DRVAL1.
    std::optional<double> chartedDepth(double latitudeDeg, double longitudeDeg) const;

    /// Pairs of positions (in whole 1e-7 degrees) for routes, the same for the same seed: both not blocked() and in
    /// charted water of at least \a minDepthM, and at least \a minDistanceShare of the diagonal of the coverage's
    /// bounding box apart. Nothing says that water connects them.
    /// \throws std::runtime_error if the chart does not yield them within 20,000 draws a pair.
    std::vector<std::pair<LatLon, LatLon>> randomPairs(unsigned seed, std::size_t count, double minDepthM,
                                                       double minDistanceShare) const;

    /// Objects that the route touches and that the blocking rules above leave aside, each once, as "CLASS LNAM":
    /// overhead (BRIDGE, CBLOHD, PIPOHD, CONVYR, CRANES), TUNNEL, and the areas and lines of regulation and traffic;
    /// DRGARE and MARCUL only with a RESTRN.
    std::vector<std::string> crossedOverheadAndRegulation(const std::vector<LatLon> &route) const;

    /// The blocking object nearest to the route, not counting the coverage's edge. Relative error below 0.1 % for
    /// distances below 1 km up to latitude 75, growing with the distance (about 1 % at 40 km and latitude 60).
    NearestHazard nearestHazard(const std::vector<LatLon> &route) const;

    GroupOneSums groupOneSums() const;

    /// How many objects block, by class. Coverage in no group 1 area counts as "GAP".
    std::map<std::string, std::size_t> blockingByClass() const;

private:
    struct Chart;
    std::unique_ptr<const Chart> chart_;
};

}  // namespace seahex::test
