#include "Quartiles.h"

#include <algorithm>
#include <cmath>

namespace reproduce_papers
{

Quartiles quartilesOf(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const auto at = [&values](double share)
    {
        const double place = share * static_cast<double>(values.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const std::size_t above = std::min(below + 1, values.size() - 1);
        return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
    };
    return {at(0.25), at(0.5), at(0.75)};
}

}  // namespace reproduce_papers
