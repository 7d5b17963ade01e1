#pragma once

#include <seahex/world/Hazard.h>

#include <functional>
#include <memory>
#include <vector>

namespace seahex
{

/// Finds the hazards near a segment by their own geometry, not by cells: an R-tree over their points, segments and
/// areas.
///
/// Immutable, thread-safe; keeps copies of what it needs. Distances are exact up to rounding, 0 where the segment
/// touches a hazard or lies inside an area of it.
class HazardIndex
{
public:
    /// Indexes those of the hazards for which `select` is true. `hazards` must outlive the index.
    HazardIndex(const std::vector<Hazard> &hazards, const std::function<bool(const Hazard &)> &select);
    ~HazardIndex();
    HazardIndex(HazardIndex &&) noexcept;
    HazardIndex &operator=(HazardIndex &&) noexcept;

    struct Near
    {
        const Hazard *hazard = nullptr;  ///< nullptr if the index is empty
        double distance = 0.0;           ///< infinite if the index is empty
    };

    /// The hazard nearest to the segment from a to b.
    Near nearest(const Point &a, const Point &b) const;

    /// Every hazard within a distance of the segment, each once, with its distance.
    std::vector<Near> within(const Point &a, const Point &b, double distance) const;

private:
    class Trees;
    std::unique_ptr<const Trees> trees_;
};

}  // namespace seahex
