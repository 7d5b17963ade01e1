#include "OppositeSteps.h"

namespace seahex
{
namespace
{

constexpr int LEAST_TABLE_BITS = 8;

bool fits(std::int64_t value)
{
    return value == static_cast<std::int32_t>(value);
}

std::uint64_t packed(const GridPoint &point)
{
    return std::uint64_t{static_cast<std::uint32_t>(point.x)} << 32 | static_cast<std::uint32_t>(point.y);
}

GridPoint unpacked(std::uint64_t point)
{
    return {static_cast<std::int32_t>(point >> 32), static_cast<std::int32_t>(point & 0xffffffff)};
}

}  // namespace

OppositeSteps::OppositeSteps(std::size_t count) : tableBits_(LEAST_TABLE_BITS)
{
    // half of the steps find an opposite where areas tile
    steps_.reserve(count / 2 + count / 8);
    while ((std::size_t{1} << tableBits_) < count)
        ++tableBits_;
    table_.assign(std::size_t{1} << tableBits_, NONE);
}

/// The same for a step and its opposite.
inline std::size_t OppositeSteps::slotOf(const PackedStep &step) const
{
    return static_cast<std::size_t>((step.from + step.to) * 0x9e3779b97f4a7c15 >> (64 - tableBits_));
}

inline bool OppositeSteps::cancelAt(std::uint32_t place, const PackedStep &opposite)
{
    if (place >= steps_.size() || steps_[place].from != opposite.from || steps_[place].to != opposite.to)
        return false;
    steps_[place].to = steps_[place].from;
    last_ = place;
    return true;
}

void OppositeSteps::add(const Step &step)
{
    if (!fits(step.from.x) || !fits(step.from.y) || !fits(step.to.x) || !fits(step.to.y))
    {
        large_.push_back(step);
        return;
    }
    const PackedStep forth{packed(step.from), packed(step.to)};
    const PackedStep back{forth.to, forth.from};
    if (last_ != NONE && (cancelAt(last_ - 1, back) || cancelAt(last_ + 1, back)))
        return;
    const std::size_t mask = table_.size() - 1;
    std::size_t slot = slotOf(forth);
    for (; table_[slot] != NONE; slot = (slot + 1) & mask)
        if (cancelAt(table_[slot], back))
            return;
    table_[slot] = static_cast<std::uint32_t>(steps_.size());
    steps_.push_back(forth);
    if (steps_.size() + steps_.size() / 4 > table_.size())
        grow();
}

void OppositeSteps::grow()
{
    tableBits_ += 1;
    table_.assign(std::size_t{1} << tableBits_, NONE);
    const std::size_t mask = table_.size() - 1;
    for (std::size_t place = 0; place < steps_.size(); ++place)
    {
        if (steps_[place].from == steps_[place].to)
            continue;
        std::size_t slot = slotOf(steps_[place]);
        while (table_[slot] != NONE)
            slot = (slot + 1) & mask;
        table_[slot] = static_cast<std::uint32_t>(place);
    }
}

std::vector<OppositeSteps::Step> OppositeSteps::left() const
{
    std::vector<Step> rest = large_;
    for (const PackedStep &step : steps_)
        if (step.from != step.to)
            rest.push_back({unpacked(step.from), unpacked(step.to)});
    return rest;
}

}  // namespace seahex
