#pragma once

namespace seahex
{

enum class SearchStatus
{
    Found,      ///< the best path is known
    Exhausted,  ///< every cell that can be reached was expanded and no goal was among them
    Stopped     ///< told to stop; call run() again to go on
};

}  // namespace seahex
