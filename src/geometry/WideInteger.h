#pragma once

namespace seahex
{

/// Products of two coordinates.
__extension__ using Wide = __int128;

inline Wide floorDivide(Wide a, Wide b)
{
    const Wide quotient = a / b;
    return quotient * b != a && ((a < 0) != (b < 0)) ? quotient - 1 : quotient;
}

}  // namespace seahex
