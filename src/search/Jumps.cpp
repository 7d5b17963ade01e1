#include "seahex/search/Jumps.h"

#include <algorithm>

namespace seahex
{

const char *toString(JumpRule rule)
{
    return rule == JumpRule::Safe ? "safe" : "hopping";
}

std::size_t Jumps::countWithin(int rings) const
{
    return static_cast<std::size_t>(std::upper_bound(rings_.begin(), rings_.end(), rings) - rings_.begin());
}

void Jumps::add(const Point &vector, double steps, int ring, const std::array<std::vector<OffsetCoord>, 2> &cells)
{
    vectors_.push_back(vector);
    lengths_.push_back(vector.norm());
    steps_.push_back(steps);
    rings_.push_back(ring);
    // Index differences depend on the parity of the row alone; the cell (0, parity) serves as the model.
    for (std::int64_t parity = 0; parity < 2; ++parity)
    {
        const auto delta = [&](OffsetCoord cell)
        {
            return static_cast<std::int32_t>((cell.row - parity) * stride_ + cell.column);
        };
        const std::vector<OffsetCoord> &needed = cells[static_cast<std::size_t>(parity)];
        Jump jump{delta(needed.front()), static_cast<std::uint16_t>(touched_.size()), 0};
        for (std::size_t i = 1; i < needed.size(); ++i)
            touched_.push_back(delta(needed[i]));
        jump.endTouch = static_cast<std::uint16_t>(touched_.size());
        jumps_[static_cast<std::size_t>(parity)].push_back(jump);
    }
    changesParity_.push_back((cells[0].front().row & 1) != 0);
}

void Jumps::findOpposites()
{
    for (const Point &vector : vectors_)
    {
        const auto back = std::find_if(vectors_.begin(), vectors_.end(),
                                       [&vector](const Point &other) { return (other + vector).norm() < 0.5; });
        opposites_.push_back(static_cast<std::size_t>(back - vectors_.begin()));
    }
}

}  // namespace seahex
