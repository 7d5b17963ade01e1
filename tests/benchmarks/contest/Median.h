#pragma once

#include <vector>

namespace seahex::contest
{

/// The middle value; of an even number the mean of the two in the middle. Not a number where there is none.
double medianOf(std::vector<double> values);

}  // namespace seahex::contest
