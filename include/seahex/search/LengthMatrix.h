#pragma once

#include <seahex/geometry/HexCoord.h>
#include <seahex/search/BatchControl.h>
#include <seahex/world/Occupancy.h>

#include <cstddef>
#include <vector>

namespace seahex
{

/// How far every one of some starts is from every one of some goals: what planners of tours ask for.
class LengthMatrix
{
public:
    LengthMatrix(std::size_t starts, std::size_t goals);

    std::size_t starts() const { return starts_; }
    std::size_t goals() const { return goals_; }

    /// In pitches; infinite where there is no path, not a number where the search was stopped before it was known.
    double operator()(std::size_t start, std::size_t goal) const { return lengths_[start * goals_ + goal]; }
    double &operator()(std::size_t start, std::size_t goal) { return lengths_[start * goals_ + goal]; }

private:
    std::size_t starts_;
    std::size_t goals_;
    std::vector<double> lengths_;
};

/// The lengths of the shortest chains of ring jumps, equal to those of single queries, over threads: a LengthTree from
/// each start, or from each goal where these are fewer, grown until it holds all of the others. So a cell is expanded
/// once for each tree, however many queries its path serves. The paths of the few pairs that are wanted in the end:
/// shortestPaths().
///
/// @param occupancy  of hexagons
/// @param rings  1, 2 or 3
/// @param starts, goals  any cells; from and to those that are blocked or outside there is no path
/// @param control  its progress counts trees
/// @throws std::length_error as LengthTree, and what `control`'s functions throw, when all threads have ended
LengthMatrix lengthMatrix(const Occupancy &occupancy, int rings, const std::vector<HexCoord> &starts,
                          const std::vector<HexCoord> &goals, const BatchControl &control = {});

}  // namespace seahex
