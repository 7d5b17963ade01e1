#include "seahex/geometry/CellLayout.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace seahex
{

CellLayout::CellLayout(std::int64_t columns, std::int64_t rows)
    : columns_(columns), rows_(rows), stride_((columns + 2 * frame + spare + 63) / 64 * 64)
{
    // one index is kept back for "no cell"
    if (columns <= 0 || rows <= 0 || stride_ > std::numeric_limits<CellIndex>::max() / (rows + 2 * frame))
        throw std::length_error("a lattice of " + std::to_string(columns) + " x " + std::to_string(rows) +
                                " cells can't be stored: at most 2^32 cells");
}

}  // namespace seahex
