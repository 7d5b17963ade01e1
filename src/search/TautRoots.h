#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace seahex
{

/// Where intervals of a TautSearch are seen from: the start, number 0, and the corners, with the shortest way known to
/// each. Corners are found by their whole coordinates through a table with open addressing.
class TautRoots
{
public:
    struct Root
    {
        double x;
        double y;
        double length;  ///< of the way from the start
        std::uint32_t before;
    };

    void begin(double x, double y)
    {
        roots_.clear();
        slots_.assign(leastSlots, 0);
        roots_.push_back({x, y, 0.0, 0});
    }

    const Root &operator[](std::uint32_t number) const { return roots_[number]; }
    std::size_t size() const { return roots_.size(); }

    /// The number of a corner to which a way is known; 0 if none is.
    std::uint32_t find(double x, double y) const
    {
        std::size_t slot = slotOf(x, y);
        while (slots_[slot] != 0)
        {
            const Root &known = roots_[slots_[slot]];
            if (known.x == x && known.y == y)
                return slots_[slot];
            slot = (slot + 1) & (slots_.size() - 1);
        }
        return 0;
    }

    /// Notes a way to a corner.
    /// @return the corner's number; true if no way as short was known
    std::pair<std::uint32_t, bool> improve(double x, double y, double length, std::uint32_t before)
    {
        std::size_t slot = slotOf(x, y);
        while (slots_[slot] != 0)
        {
            Root &known = roots_[slots_[slot]];
            if (known.x == x && known.y == y)
            {
                // what is shorter by rounding alone would be expanded again for nothing
                if (length >= known.length * (1.0 - rounding))
                    return {slots_[slot], false};
                known.length = length;
                known.before = before;
                return {slots_[slot], true};
            }
            slot = (slot + 1) & (slots_.size() - 1);
        }
        const auto number = static_cast<std::uint32_t>(roots_.size());
        roots_.push_back({x, y, length, before});
        slots_[slot] = number;
        if (2 * roots_.size() > slots_.size())
            grow();
        return {number, true};
    }

private:
    static constexpr std::size_t leastSlots = 1024;
    static constexpr double rounding = 1e-13;

    std::size_t slotOf(double x, double y) const
    {
        const std::uint64_t key = static_cast<std::uint64_t>(y) << 32 ^ static_cast<std::uint64_t>(x);
        const std::uint64_t mixed = key * 0x9E3779B97F4A7C15U;
        return static_cast<std::size_t>(mixed ^ mixed >> 32) & (slots_.size() - 1);
    }

    void grow()
    {
        slots_.assign(2 * slots_.size(), 0);
        for (std::size_t number = 1; number < roots_.size(); ++number)
        {
            std::size_t slot = slotOf(roots_[number].x, roots_[number].y);
            while (slots_[slot] != 0)
                slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = static_cast<std::uint32_t>(number);
        }
    }

    std::vector<Root> roots_;
    std::vector<std::uint32_t> slots_;
};

}  // namespace seahex
