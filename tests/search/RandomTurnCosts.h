#pragma once

#include <seahex/search/TurnBound.h>

#include "support/Random.h"

namespace seahex::test
{

/// Costs at random, nothing for turns or for radians among them.
inline TurnCosts randomTurnCosts(Random &random)
{
    const auto cost = [&random]
    {
        return random.chance(0.3)   ? 0.0
               : random.chance(0.3) ? static_cast<double>(random.integer(1, 5))
                                    : random.real(0.0, 4.0);
    };
    const double perTurn = cost();
    return {perTurn, cost()};
}

}  // namespace seahex::test
