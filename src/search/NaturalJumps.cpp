#include "seahex/search/NaturalJumps.h"

#include "seahex/geometry/HexRing.h"
#include "seahex/geometry/HexTraversal.h"
#include "seahex/geometry/HexWindow.h"
#include "seahex/search/UnitLengths.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace seahex
{
namespace
{

constexpr std::uint64_t never = ~std::uint64_t{0};  // of cells that would have to be free

/// One of the jumps, as the tables need it.
struct Way
{
    HexCoord offset;
    std::int64_t length;
    int rank;  // in the order of last jumps
};

/// The jumps in the order of HexJumps.
std::vector<Way> waysOf(int rings)
{
    std::vector<Way> ways;
    const units::RingNorm norm(rings);
    for (const RingOffset &jump : ringOffsets(rings))
        if (jump.primitive)
            ways.push_back({jump.offset,
                            norm(static_cast<std::int32_t>(jump.offset.q), static_cast<std::int32_t>(jump.offset.s)),
                            0});
    const auto course = [&ways](std::size_t k)
    {
        const auto s = static_cast<double>(ways[k].offset.s);
        return std::atan2(s, (static_cast<double>(ways[k].offset.q) + 0.5 * s) * 2.0 / std::sqrt(3.0));
    };
    std::vector<std::size_t> byCourse(ways.size());
    for (std::size_t k = 0; k < ways.size(); ++k)
        byCourse[k] = k;
    std::sort(byCourse.begin(), byCourse.end(), [&](std::size_t a, std::size_t b) { return course(a) < course(b); });
    for (std::size_t i = 0; i < byCourse.size(); ++i)
        ways[byCourse[i]].rank = static_cast<int>((i + 1) % 2 * ways.size() + i);
    return ways;
}

/// The chains of jumps that may stand for an arrival at x and a jump from there.
class Chains
{
public:
    Chains(int rings, const std::vector<Way> &ways, std::int64_t parity)
        : ways_(ways), norm_(rings), x_(toCube({0, parity})), parity_(parity)
    {
    }

    /// Cells that the jump needs, that from which it starts left out; empty if one is out of the window around x.
    std::optional<std::uint64_t> touched(HexCoord from, const Way &way) const
    {
        std::uint64_t mask = 0;
        const bool isInside = forEachTouchedCell(from, from + way.offset,
                                                 [&](HexCoord cell)
                                                 {
                                                     const auto bit = this->bit(cell);
                                                     if (bit && cell != from)
                                                         mask |= *bit;
                                                     return bit.has_value();
                                                 });
        return isInside ? std::optional(mask) : std::nullopt;
    }

    /// What must be free for one of the chains from p = x - arrival to x + departure; of masks that imply each other
    /// the weakest only, those of few cells first.
    std::vector<std::uint64_t> instead(const Way &arrival, const Way &departure)
    {
        const HexCoord p{x_.q - arrival.offset.q, x_.s - arrival.offset.s};
        target_ = x_ + departure.offset;
        known_ = *touched(p, arrival) | *touched(x_, departure) | *bit(x_) | *bit(p);
        budget_ = arrival.length + departure.length;
        lastBefore_ = departure.rank;
        masks_.clear();
        extend(p, 0, 0, nullptr, 0);
        return weakest();
    }

private:
    std::optional<std::uint64_t> bit(HexCoord cell) const
    {
        const OffsetCoord offset = toOffset(cell);
        const OffsetCoord difference{offset.column, offset.row - parity_};
        return HexWindow::contains(difference) ? std::optional(HexWindow::bit(difference)) : std::nullopt;
    }

    void extend(HexCoord at, std::int64_t length, std::uint64_t mask, const Way *last, int count)
    {
        constexpr int longest = 4;
        if (at == target_ && (length < budget_ || (last != nullptr && last->rank < lastBefore_)))
            masks_.push_back(mask);
        if (count == longest)
            return;
        for (const Way &way : ways_)
        {
            const HexCoord to = at + way.offset;
            const HexCoord left = target_ - to;
            if (to == x_ ||
                length + way.length + norm_(static_cast<std::int32_t>(left.q), static_cast<std::int32_t>(left.s)) >
                    budget_)
                continue;
            if (const auto needed = touched(at, way))
                extend(to, length + way.length, mask | (*needed & ~known_), &way, count + 1);
        }
    }

    std::vector<std::uint64_t> weakest()
    {
        const auto count = [](std::uint64_t mask)
        {
            return __builtin_popcountll(mask);
        };
        std::sort(masks_.begin(), masks_.end(),
                  [&count](std::uint64_t a, std::uint64_t b)
                  { return count(a) != count(b) ? count(a) < count(b) : a < b; });
        std::vector<std::uint64_t> kept;
        for (const std::uint64_t mask : masks_)
            if (std::none_of(kept.begin(), kept.end(), [mask](std::uint64_t other) { return (other & ~mask) == 0; }))
                kept.push_back(mask);
        return kept;
    }

    const std::vector<Way> &ways_;
    units::RingNorm norm_;
    HexCoord x_;
    std::int64_t parity_;
    HexCoord target_;
    std::uint64_t known_ = 0;
    std::int64_t budget_ = 0;
    int lastBefore_ = 0;
    std::vector<std::uint64_t> masks_;
};

}  // namespace

NaturalJumps::NaturalJumps(int rings) : arrivals_()
{
    const std::vector<Way> ways = waysOf(rings);
    for (unsigned int parity = 0; parity < 2; ++parity)
    {
        Chains chains(rings, ways, parity);
        for (std::size_t d = 0; d <= ways.size(); ++d)
        {
            const bool isStart = d == ways.size();
            Arrival &arrival = arrivals_[32 * parity + (isStart ? start : d)];
            arrival.firstChoice = static_cast<std::uint32_t>(choices_.size());
            for (std::size_t e = 0; e < ways.size(); ++e)
            {
                Choice choice{*chains.touched(toCube({0, parity}), ways[e]),
                              {never, never, never},
                              static_cast<std::uint32_t>(e)};
                const auto masks = isStart ? std::vector<std::uint64_t>() : chains.instead(ways[d], ways[e]);
                if (!masks.empty() && masks.front() == 0)
                    continue;  // always pruned
                if (masks.empty())
                    arrival.open |= std::uint32_t{1} << e;
                arrival.decisive |= masks.empty() ? choice.touched : masks.front();
                std::copy_n(masks.begin(), std::min(masks.size(), Choice::chains), choice.instead.begin());
                choices_.push_back(choice);
            }
            arrival.endChoice = static_cast<std::uint32_t>(choices_.size());
        }
    }
}

const NaturalJumps &NaturalJumps::ofRings(int rings)
{
    static const NaturalJumps one(1);
    static const NaturalJumps two(2);
    static const NaturalJumps three(3);
    return rings == 1 ? one : rings == 2 ? two : three;
}

}  // namespace seahex
