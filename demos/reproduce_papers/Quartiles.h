#pragma once

#include <vector>

namespace reproduce_papers
{

/// The median, and the quartiles below and above it, linear between neighbours.
struct Quartiles
{
    double lower = 0.0;
    double median = 0.0;
    double upper = 0.0;
};

/// @param values  at least one
Quartiles quartilesOf(std::vector<double> values);

}  // namespace reproduce_papers
