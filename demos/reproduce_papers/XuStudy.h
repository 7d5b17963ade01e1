#pragma once

#include "Study.h"

#include <cstdint>

namespace reproduce_papers
{

/// What to try the layered planning on.
struct XuOptions
{
    unsigned terrains = 100;
    std::uint32_t seed = 1;
    unsigned threads = 2;
};

/// The experiment of [Xu] on random terrains, for its own is not published: its greedy selection, the exact one and an
/// ant colony on the same slices, each as selected and after its optimisation; the claims that it makes of its method
/// against the ants, terrain by terrain; a picture of one terrain.
Study xuStudy(const XuOptions &options);

}  // namespace reproduce_papers
