#pragma once

#include <seahex/route/Route.h>
#include <seahex/search/Guidance.h>
#include <seahex/search/Jumps.h>

#include <string>

namespace reproduce_papers
{

/// Which cells a method plans on; the sizes are Sea's.
enum class Cells
{
    Hexagons,
    Squares,       ///< as far from centre to centre as the hexagons
    SquaresOfArea  ///< of the hexagons' area
};

/// What a method minimises.
enum class Cost
{
    Length,   ///< metres, or degrees
    Steps,    ///< the lattice's own metric: D of [Cheng2020] eq. 4, octile on squares
    Sailing,  ///< [Wang2017] eq. 1: length times the safety weight of the cell of arrival
};

/// One way to plan, as a paper or this project has it: all settings that matter.
struct Method
{
    Cells cells = Cells::Hexagons;
    int rings = 1;       ///< on hexagons
    int neighbours = 8;  ///< on squares
    Cost cost = Cost::Length;
    seahex::Guidance guidance = seahex::Guidance::Distance;
    seahex::JumpRule jumps = seahex::JumpRule::Safe;
};

inline Method hexagons(int rings)
{
    Method method;
    method.rings = rings;
    return method;
}

inline Method squares(Cells cells = Cells::Squares)
{
    Method method;
    method.cells = cells;
    return method;
}

inline Method with(Method method, Cost cost)
{
    method.cost = cost;
    return method;
}

inline Method with(Method method, seahex::Guidance guidance)
{
    method.guidance = guidance;
    return method;
}

inline Method with(Method method, seahex::JumpRule jumps)
{
    method.jumps = jumps;
    return method;
}

}  // namespace reproduce_papers
