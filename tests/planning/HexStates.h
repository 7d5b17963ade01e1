#pragma once

#include <seahex/planning/HexStateSpace.h>

#include <ompl/base/ScopedState.h>

#include <memory>

namespace seahex::test
{

using CellState = ompl::base::ScopedState<HexStateSpace>;

inline std::shared_ptr<HexStateSpace> spaceOf(std::int64_t columns, std::int64_t rows, double pitch = 1.0,
                                              const Point &corner = Point(0, 0))
{
    return std::make_shared<HexStateSpace>(HexLattice(corner, pitch, columns, rows));
}

inline CellState stateOf(const std::shared_ptr<HexStateSpace> &space, HexCoord cell)
{
    CellState state(space);
    state->setCell(cell);
    return state;
}

/// |cell|^2 in pitches.
inline std::int64_t square(std::int64_t q, std::int64_t s)
{
    return q * q + q * s + s * s;
}

}  // namespace seahex::test
