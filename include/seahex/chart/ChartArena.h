#pragma once

#include <seahex/chart/Chart.h>
#include <seahex/chart/Projection.h>
#include <seahex/geometry/HexLattice.h>
#include <seahex/world/BlockingRule.h>
#include <seahex/world/HazardIndex.h>
#include <seahex/world/Occupancy.h>
#include <seahex/world/Vessel.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace seahex
{

/// What to make of a chart.
struct ArenaOptions
{
    Vessel vessel;
    HazardScope scope = HazardScope::All;
    /// The frame; a transverse Mercator at the middle of the coverage if empty.
    std::optional<Projection> projection;
    /// The lattice; one that covers the coverage if empty.
    std::optional<HexLattice> lattice;
    /// Pitch of that lattice in the frame's unit; 0: automaticPitch().
    double pitch = 0.0;
    /// A file to keep the cells in (loadOrMake): one that was made of exactly this (cellsProvenance) spares filling
    /// them. Empty: none.
    std::filesystem::path cells = {};
};

/// A chart as one vessel sees it in one frame: the occupancy that planners use, and the hazards behind it that explain
/// it.
///
/// The occupancy blocks a cell if a blocking hazard comes within keepOutRadiusM of it, or what lies outside the
/// coverage comes within the vessel's margin. In a metric frame both distances are enlarged by growthM, which covers
/// what densified edges and written legs may deviate: a written leg that was planned on free cells keeps the full
/// radius from the true hazard. All of these are metres on the ground; the plane's stretch is added. In the plate
/// carree frame metres have no meaning: it takes land only and no margin, and radii are 0.
///
/// Immutable; const functions, thread-safe.
class ChartArena
{
public:
    /// Projection::edgeToleranceM plus legToleranceM.
    static constexpr double growthM = 1.0;

    /// @throws std::domain_error for a pitch that is not positive; in a frame without metres also for a margin, and for
    ///         any other scope than land only; ChartUnreadable if cells are to be kept and a file of the chart can't be
    ///         read again; none for a file of cells, see warnings()
    ChartArena(const Chart &chart, const ArenaOptions &options);

    const Vessel &vessel() const { return vessel_; }
    const Projection &projection() const { return projection_; }
    const std::shared_ptr<const HexOccupancy> &occupancy() const { return occupancy_; }
    /// Was the occupancy in ArenaOptions::cells?
    bool isFromFile() const { return isFromFile_; }
    /// What is wrong with that file, each one sentence; the occupancy is right nevertheless.
    const std::vector<std::string> &warnings() const { return warnings_; }
    /// The same water on another lattice: hazards, verdicts and radii are those of this arena.
    std::shared_ptr<const HexOccupancy> fill(const HexLattice &lattice) const;
    std::shared_ptr<const SquareOccupancy> fill(const SquareLattice &lattice) const;
    /// Every hazard of the chart in the plane, blocking or not, and what each means for the vessel (same order).
    const std::vector<Hazard> &hazards() const { return hazards_; }
    const std::vector<Verdict> &verdicts() const { return verdicts_; }
    /// The coverage in the plane.
    const Shape &coverage() const { return coverage_; }
    /// Most metres of the plane to a metre on the ground anywhere on the chart (Projection::largestScale).
    double scale() const { return scale_; }
    /// Wall time of projecting, judging and filling (or taking from the file), milliseconds.
    double buildMs() const { return buildMs_; }

    /// Why a cell is blocked: one sentence for each hazard within its radius of the cell, and for the coverage's edge.
    /// Empty for a free cell.
    std::vector<std::string> explainCell(HexCoord cell) const;

    /// The same for a point by itself, without the cell around it.
    std::vector<std::string> explainPoint(const Point &p) const;

private:
    template <class KnownLattice>
    std::shared_ptr<const LatticeOccupancy<KnownLattice>> fillCells(const KnownLattice &lattice) const;
    void keepCells(const Chart &chart, const HexLattice &lattice, const std::filesystem::path &file);
    double inPlane(double distanceM) const;
    double radius(std::size_t hazard) const;
    std::vector<std::string> explain(const Point &p, std::optional<HexCoord> cell) const;

    Vessel vessel_;
    HazardScope scope_;
    Projection projection_;
    std::vector<Hazard> hazards_;
    std::vector<Verdict> verdicts_;
    Shape coverage_;
    std::shared_ptr<const HexOccupancy> occupancy_;
    bool isFromFile_ = false;
    std::vector<std::string> warnings_;
    double scale_ = 1.0;
    double buildMs_ = 0.0;
};

/// The pitch that plan_route takes if none is given: the larger of 20 m and what gives 4 million cells over the box.
double automaticPitchM(const Box &box);

/// The occupancy of a chart for a vessel on a lattice of the given pitch (metres, 0 for automatic) in the chart's own
/// transverse Mercator: the short way for programs that need neither explanations nor positions.
std::shared_ptr<const HexOccupancy> buildOccupancy(const Chart &chart, const Vessel &vessel, double pitchM);

}  // namespace seahex
