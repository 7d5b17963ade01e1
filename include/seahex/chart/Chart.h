#pragma once

#include <seahex/geometry/GeoPoint.h>
#include <seahex/world/Hazard.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace seahex
{

/// A west, south, east, north box in degrees.
struct GeoBox
{
    double westDeg = 0.0;
    double southDeg = 0.0;
    double eastDeg = 0.0;
    double northDeg = 0.0;

    GeoPoint centre() const;
    bool contains(const GeoPoint &position) const;
};

/// Does the sum of the group 1 areas (DEPARE, DRGARE, LNDARE, UNSARE, PONTON, FLODOC, HULKES) equal the coverage?
///
/// S-57 demands that they tile it. The sums are taken over the cell's own integer grid (degrees times COMF, 1e7 where a
/// source has no COMF), so that equal means equal.
struct GroupOneCheck
{
    bool applicable = false;  ///< false where a source has no M_COVR to compare with
    /// Twice the coverage area minus twice the sum of the group 1 areas, in squared grid units; 0 for a sound cell. A
    /// decimal number as text, because it may exceed 64 bits.
    std::string twiceAreaDifference = "0";
    bool tiles = true;         ///< true if the difference is 0
    double gapFraction = 0.0;  ///< share of the coverage that no group 1 area covers, 0 for a sound cell
};

/// What was found in one cell (or in the OGR sources that were read as one), for the report.
struct CellReport
{
    std::string name;    ///< DSNM without its extension, or the file's stem
    std::string source;  ///< path as given
    /// What was read: the base cell and every update found with it, or the files that OGR's drivers name.
    std::vector<std::filesystem::path> files;
    std::optional<int> edition;
    std::optional<int> update;         ///< last update applied
    std::string issueDate;             ///< DSID_ISDT, may be empty
    std::optional<int> scale;          ///< CSCL: 12000 means 1:12,000
    std::optional<int> verticalDatum;  ///< DSPM_VDAT, heights
    std::optional<int> soundingDatum;  ///< DSPM_SDAT, depths
    GeoBox bounds;                     ///< of the coverage
    GroupOneCheck groupOne;

    std::size_t featuresRead = 0;  ///< features of the source, a multipoint of soundings counted once
    std::size_t featuresUsed = 0;  ///< those that became hazards or coverage
    /// Why features were not used: reason -> class acronym -> count.
    std::map<std::string, std::map<std::string, std::size_t>> skipped;
    std::vector<std::string> warnings;  ///< each one sentence
};

/// A line of equal depth (DEPCNT), in degrees. It is no hazard: it tells of the seabed.
struct DepthContour
{
    double depthM = 0.0;  ///< VALDCO, below the sounding datum; what dries is negative
    GeoShape shape;
};

/// Chart objects in degrees with their provenance, as read from one or more sources. A value: copy and share freely.
///
/// Several cells are pooled: every hazard of every cell counts, and the coverage is the union of theirs. Where two
/// cells overlap, the more restrictive therefore wins.
struct Chart
{
    /// Every object of a class in the catalogue, but for those that are ignored; and the gaps of the group 1 areas,
    /// whose rule is ChartGap and whose class is that of the coverage, M_COVR. Each sounding is an object of its own.
    std::vector<GeoHazard> hazards;
    std::vector<DepthContour> contours;  ///< those whose depth is known
    GeoShape coverage;                   ///< areas only: M_COVR with CATCOV 1, united; water outside is unknown
    GeoBox bounds;                       ///< of the coverage
    std::vector<CellReport> cells;       ///< one per cell
    double readMs = 0.0;                 ///< wall time of reading, milliseconds
};

}  // namespace seahex
