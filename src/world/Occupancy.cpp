#include "seahex/world/Occupancy.h"

#include <bitset>
#include <stdexcept>
#include <utility>

namespace seahex
{

Occupancy::Occupancy(const Lattice &lattice, const CellLayout &layout, CellWords words)
    : lattice_(lattice), layout_(layout), words_(std::move(words)), blockedCount_(0)
{
    if (words_.size() != layout_.wordCount() || layout_.columns() != lattice_.columns() ||
        layout_.rows() != lattice_.rows())
        throw std::length_error("the occupancy's bits do not fit its lattice");
    std::int64_t blocked = 0;
    for (const std::uint64_t word : words_)
        blocked += static_cast<std::int64_t>(std::bitset<64>(word).count());
    blockedCount_ = blocked - (static_cast<std::int64_t>(layout_.size()) - lattice_.cellCount());
}

}  // namespace seahex
