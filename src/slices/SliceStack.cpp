#include "seahex/slices/SliceStack.h"

#include <cmath>

namespace seahex
{

SliceStack::SliceStack(const SliceFrame &frame)
    : frame_(frame), bits_(static_cast<std::size_t>(frame.planes()) * frame.cellCount(), false)
{
}

void SliceStack::inflate()
{
    const std::vector<bool> before = bits_;
    for (int plane = 0; plane < frame_.planes(); ++plane)
        for (int across = 0; across < frame_.across(); ++across)
            for (int level = 0; level < frame_.levels(); ++level)
                for (const SliceCell next : {SliceCell{across, level - 1}, SliceCell{across, level + 1}})
                    if (frame_.contains(next) && before[number(plane, next)])
                        block(plane, {across, level});
}

double SliceStack::danger(int plane, SliceCell cell, int neighbourhood) const
{
    const int reach = neighbourhood / 2;
    int blocked = 0;
    for (int across = cell.across - reach; across <= cell.across + reach; ++across)
        for (int level = cell.level - reach; level <= cell.level + reach; ++level)
            if (SliceCell{across, level} != cell && isBlocked(plane, {across, level}))
                ++blocked;
    return static_cast<double>(blocked) / (neighbourhood * neighbourhood - 1);
}

bool SliceStack::isFreeAt(int plane, const Eigen::Vector3d &place) const
{
    constexpr double half = 0.5 + 1e-9;  // a place halfway between two points belongs to both, however it was rounded
    const Eigen::Vector2d at = frame_.gridCoordinates(place);
    const auto first = [&](int k)
    {
        return static_cast<int>(std::ceil(at[k] - half));
    };
    const auto last = [&](int k)
    {
        return static_cast<int>(std::floor(at[k] + half));
    };
    for (int across = first(0); across <= last(0); ++across)
        for (int level = first(1); level <= last(1); ++level)
            if (isBlocked(plane, {across, level}))
                return false;
    return true;
}

}  // namespace seahex
