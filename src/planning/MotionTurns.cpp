#include "planning/MotionTurns.h"

#include <ompl/util/Exception.h>

namespace seahex
{

PlanarEmbedding embeddingWithHeading(const ompl::base::StateSpace *space)
{
    const PlanarEmbedding embedding(space);
    if (!embedding.hasHeading())
        throw ompl::Exception("seahex",
                              "turns can be charged in SE(2) only: a motion knows its two states, and those of '" +
                                  space->getName() + "' have no heading");
    return embedding;
}

}  // namespace seahex
