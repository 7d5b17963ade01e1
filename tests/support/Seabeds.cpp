#include "support/Seabeds.h"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace seahex::test
{

std::shared_ptr<const Bathymetry> randomSeabed(Random &random, std::int64_t columns, std::int64_t rows,
                                               double unknownShare)
{
    const NodeGrid grid(random.pointIn({Point(-1e4, -1e4), Point(1e4, 1e4)}),
                        Point(random.real(5.0, 200.0), random.real(5.0, 200.0)), columns, rows);
    const double across = random.real(0.3, 1.5);
    const double along = random.real(0.3, 1.5);
    std::vector<float> depths;
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t column = 0; column < columns; ++column)
        {
            const double waves =
                std::sin(across * static_cast<double>(column)) * std::cos(along * static_cast<double>(row));
            const double depth = 25.0 + 25.0 * waves + random.real(-10.0, 10.0);
            depths.push_back(random.chance(unknownShare) ? Bathymetry::unknownDepth : static_cast<float>(depth));
        }
    return std::make_shared<const Bathymetry>(grid, std::move(depths));
}

Point3 anyPosition(Random &random, const DiveArena &arena)
{
    Point3 p;
    for (int axis = 0; axis < 3; ++axis)
        p[axis] = random.chance(0.02) ? arena.lowest()[axis] : random.real(arena.lowest()[axis], arena.highest()[axis]);
    return p;
}

Point3 freePosition(Random &random, const DiveArena &arena)
{
    for (int i = 0; i < 1000; ++i)
    {
        const Point3 p = anyPosition(random, arena);
        if (arena.isFree(p))
            return p;
    }
    throw std::runtime_error("no free position found in the arena, " + random.seedText());
}

}  // namespace seahex::test
