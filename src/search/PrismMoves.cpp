#include "seahex/search/PrismMoves.h"

#include "seahex/geometry/HexNorm.h"

#include <algorithm>
#include <cmath>

namespace seahex
{

PrismMoves::PrismMoves(const PrismLattice &lattice, const CellLayout &layout, int rings, double climb)
    : jumps_(layout, rings, JumpSet::All), pitch_(lattice.pitch()), rings_(rings)
{
    const double height = lattice.layers() > 1 ? lattice.thickness() : 0.0;
    double shortest = 0.0;  // of the jumps that climb
    for (std::size_t k = 0; k < jumps_.size(); ++k)
    {
        const auto jump = static_cast<std::uint8_t>(k);
        if (jumps_.offset(k).primitive)
            moves_.push_back({jump, 0, jumps_.length(k)});
        const double run = jumps_.length(k) * pitch_;
        if (height == 0.0 || !isClimbable(Point3(run, 0.0, height), climb))
            continue;
        shortest = canClimb_ ? std::min(shortest, run) : run;
        canClimb_ = true;
        for (const int layers : {-1, 1})
            moves_.push_back({jump, static_cast<std::int8_t>(layers), std::hypot(run, height) / pitch_});
    }
    if (height > 0.0 && climb == 0.0)
        for (const int layers : {-1, 1})
            moves_.push_back({PrismMove::vertical, static_cast<std::int8_t>(layers), height / pitch_});
    if (canClimb_)
    {
        leastRun_ = climb == 0.0 ? 0.0 : shortest / height;
        greatestRun_ = static_cast<double>(rings) * pitch_ / height;
    }
}

double PrismMoves::norm(const Point3 &vector) const
{
    const double height = std::abs(vector.z()) / pitch_;
    const double run = std::max(vectorRingNorm(horizontal(vector) / pitch_, rings_), height * leastRun_);
    const double climbing = std::min(run, height * greatestRun_);
    return std::sqrt(climbing * climbing + height * height) + (run - climbing);
}

}  // namespace seahex
