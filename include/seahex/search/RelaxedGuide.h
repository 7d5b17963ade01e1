#pragma once

#include <seahex/search/RelaxedDistance.h>
#include <seahex/world/Occupancy.h>

#include <cstdint>
#include <limits>
#include <memory>

namespace seahex
{

/// When a search gets the help of a RelaxedDistance, on hexagons: one that ends soon needs none.
///
/// To pass all lines costs about as much as to expand a 128th of the lattice's cells. So the guide waits for as many
/// expansions: the search takes at most about twice the time that it would without, and mostly much less. Then one line
/// is passed with each expansion, so that none takes long, and with the last one the bounds grow. Copies share the
/// lines: one guide serves one search at a time.
class RelaxedGuide
{
public:
    /// One that never helps.
    RelaxedGuide() = default;

    /// @param occupancy  every jump of the search touches cells that are free there, and no others
    /// @param goal  the search's only goal cell
    /// @param rings  as for RelaxedDistance
    RelaxedGuide(std::shared_ptr<const Occupancy> occupancy, OffsetCoord start, OffsetCoord goal, int rings);

    /// Begins anew for the jumps of other rings.
    void useRings(int rings);

    /// As AStar asks for it.
    bool sharpen(std::uint64_t expanded) { return expanded >= patience_ && passLine(); }

    /// The larger of a bound and, once there is one, the relaxed distance. Where that is infinite no cell of the search
    /// can reach the goal; it is left out then, so that the search makes for the goal all the same.
    double raise(double bound, OffsetCoord cell) const;

private:
    static constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

    bool passLine();

    std::shared_ptr<const Occupancy> occupancy_;
    HexCoord start_;
    HexCoord goal_;
    int rings_ = 1;
    std::uint64_t patience_ = never;
    std::shared_ptr<RelaxedDistance> distance_;
    bool isSharp_ = false;
};

}  // namespace seahex
