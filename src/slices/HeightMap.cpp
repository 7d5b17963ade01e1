#include "seahex/slices/HeightMap.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace seahex
{
namespace
{

struct Hill
{
    Eigen::Vector2d top;
    double height;
    double width;

    double at(const Eigen::Vector2d &p) const
    {
        return height * std::exp(-0.5 * (p - top).squaredNorm() / (width * width));
    }
};

constexpr double floorHeight = 1.0;

double sumOf(const std::vector<Hill> &hills, const Eigen::Vector2d &p)
{
    double height = floorHeight;
    for (const Hill &hill : hills)
        height += hill.at(p);
    return height;
}

}  // namespace

double HeightMap::height(double x, double y) const
{
    const double u = std::clamp(x, 1.0, static_cast<double>(size_));
    const double v = std::clamp(y, 1.0, static_cast<double>(size_));
    const int column = std::min(static_cast<int>(u), size_ - 1);
    const int row = std::min(static_cast<int>(v), size_ - 1);
    const double s = u - column;
    const double t = v - row;
    return (1.0 - t) * ((1.0 - s) * at(column, row) + s * at(column + 1, row)) +
           t * ((1.0 - s) * at(column, row + 1) + s * at(column + 1, row + 1));
}

HeightMap randomHills(int size, std::uint64_t seed, const std::vector<Eigen::Vector3d> &keptClear)
{
    std::mt19937_64 engine(seed);
    const auto between = [&](double low, double high)  // the same with every standard library
    {
        return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
    };
    std::vector<Hill> hills;
    for (int drawn = 0; drawn < size; ++drawn)
    {
        Hill hill;
        hill.top.x() = between(1.0, size);
        hill.top.y() = between(1.0, size);
        hill.height = between(0.15, 0.7) * size;
        hill.width = between(0.04, 0.12) * size;
        hills.push_back(hill);
        const auto isTooHigh = [&](const Eigen::Vector3d &place)
        {
            return sumOf(hills, place.head<2>()) > place.z() - 2.0;
        };
        if (std::any_of(keptClear.begin(), keptClear.end(), isTooHigh))
            hills.pop_back();
    }
    std::vector<double> heights;
    for (int y = 1; y <= size; ++y)
        for (int x = 1; x <= size; ++x)
            heights.push_back(std::min(sumOf(hills, {x, y}), 0.9 * size));
    return {size, std::move(heights)};
}

}  // namespace seahex
