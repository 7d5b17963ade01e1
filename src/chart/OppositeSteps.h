#pragma once

#include "GridCoordinates.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace seahex
{

/// A multiset of steps from one grid point to another in which a step and its opposite cancel.
///
/// Neighbouring areas share whole chains of corners and run along them in opposite directions, so the opposite of the
/// next step is most often stored just before that of the last one: it is looked for there before the hash table is
/// asked.
class OppositeSteps
{
public:
    struct Step
    {
        GridPoint from;
        GridPoint to;
    };

    /// @param count  how many steps will come; more may, but take longer
    explicit OppositeSteps(std::size_t count);

    void add(const Step &step);

    /// The steps for which no opposite was found. Those beyond 32-bit coordinates are not looked for.
    std::vector<Step> left() const;

private:
    /// Both coordinates of a point in one word.
    struct PackedStep
    {
        std::uint64_t from;
        std::uint64_t to;
    };

    static constexpr std::uint32_t NONE = ~std::uint32_t{0};

    bool cancelAt(std::uint32_t place, const PackedStep &opposite);
    void grow();
    std::size_t slotOf(const PackedStep &step) const;

    std::vector<PackedStep> steps_;     // a cancelled one is made a step of no length
    std::vector<std::uint32_t> table_;  // open addressing; cancelled steps keep their slots
    int tableBits_;
    std::uint32_t last_ = NONE;  // where the last opposite was found
    std::vector<Step> large_;
};

}  // namespace seahex
