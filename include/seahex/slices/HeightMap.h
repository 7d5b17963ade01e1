#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace seahex
{

/// Seabed heights on a grid of n x n points at x, y = 1, 2, ..., n, z upwards: the environment of [Xu], where all
/// lengths are divided by the vehicle's.
class HeightMap
{
public:
    /// Heights row by row (y), n^2 of them, n at least 2.
    HeightMap(int size, std::vector<double> heights) : size_(size), heights_(std::move(heights)) {}

    int size() const { return size_; }
    /// At a grid point; x and y from 1 to n.
    double at(int x, int y) const
    {
        return heights_[static_cast<std::size_t>(y - 1) * static_cast<std::size_t>(size_) +
                        static_cast<std::size_t>(x - 1)];
    }
    /// Bilinear between the grid points; beyond the grid as on its edge.
    double height(double x, double y) const;

private:
    int size_;
    std::vector<double> heights_;
};

/// Round hills at random on a seabed that is flat at height 1: the same for the same seed everywhere. Their sum rises
/// to nine tenths of the size at most. No hill comes nearer than two below one of the places to be kept clear.
HeightMap randomHills(int size, std::uint64_t seed, const std::vector<Eigen::Vector3d> &keptClear = {});

}  // namespace seahex
