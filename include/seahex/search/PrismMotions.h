#pragma once

#include <seahex/geometry/CellLayout.h>

#include <cstddef>
#include <cstdint>

namespace seahex
{

/// A straight motion between two nodes of a prism lattice.
struct PrismMotion
{
    CellIndex from;
    CellIndex to;
    int fromLayer;
    int toLayer;
    std::uint8_t jump;  ///< of PrismMoves; PrismMove::vertical where `from` is `to`
};

/// Who knows which motions of a search on prisms are valid.
class PrismMotions
{
public:
    enum class Answer
    {
        Valid,
        Invalid,
        Interrupted  ///< no time to say: to be asked again later
    };

    virtual ~PrismMotions() = default;

    /// The node `from` is free: the search is there. `to` may lie outside the lattice's rectangle, but not outside its
    /// layers.
    virtual Answer judge(const PrismMotion &motion) = 0;
};

}  // namespace seahex
