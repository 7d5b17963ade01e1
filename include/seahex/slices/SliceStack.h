#pragma once

#include <seahex/slices/SliceFrame.h>

#include <vector>

namespace seahex
{

/// The slices of [Xu] and which of their grid points are blocked: a matrix of ones and zeros for every plane. What lies
/// beyond a grid counts as blocked.
class SliceStack
{
public:
    /// All points are free.
    explicit SliceStack(const SliceFrame &frame);

    const SliceFrame &frame() const { return frame_; }

    void block(int plane, SliceCell cell) { bits_[number(plane, cell)] = true; }
    bool isBlocked(int plane, SliceCell cell) const { return !frame_.contains(cell) || bits_[number(plane, cell)]; }

    /// Blocks the points directly above and below each blocked one, as [Xu] does by taking the seabed's height as its
    /// integer part plus one: what lies between two levels is no nearer than the next of them. Both ways, because z may
    /// point up or down.
    void inflate();

    /// The share of blocked points among the neighbours in a square of `neighbourhood` points by as many, an odd
    /// number: D of [Xu] eq. 3, where three give eight neighbours. 1: none of them is free, and the point itself
    /// counts as unreachable.
    double danger(int plane, SliceCell cell, int neighbourhood) const;

    /// True if a place on a plane lies in a free cell: the grid point nearest to it is free, or all of them where
    /// several are.
    bool isFreeAt(int plane, const Eigen::Vector3d &place) const;

private:
    std::size_t number(int plane, SliceCell cell) const
    {
        return static_cast<std::size_t>(plane) * frame_.cellCount() + frame_.index(cell);
    }

    SliceFrame frame_;
    std::vector<bool> bits_;
};

}  // namespace seahex
