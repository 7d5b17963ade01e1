#include "seahex/world/CellBits.h"

namespace seahex
{

void CellBits::setOutside()
{
    const auto frame = CellLayout::frame;
    const auto stride = static_cast<std::size_t>(layout_.stride());
    for (std::int64_t row = -frame; row < layout_.rows() + frame; ++row)
    {
        const auto begin = static_cast<std::size_t>(row + frame) * stride;
        if (row < 0 || row >= layout_.rows())
        {
            setIndices(begin, begin + stride - 1);
            continue;
        }
        setIndices(begin, begin + frame - 1);
        setIndices(begin + static_cast<std::size_t>(layout_.columns() + frame), begin + stride - 1);
    }
}

}  // namespace seahex
