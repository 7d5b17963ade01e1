#pragma once

#include "Trial.h"

#include <optional>
#include <string>
#include <vector>

namespace reproduce_papers
{

/// Something that a paper says, or this project, as a number for each pair of start and goal and the side of a limit on
/// which it should lie.
struct Claim
{
    enum class Side
    {
        Less,
        More
    };

    std::string id;
    std::string source;
    std::string text;
    double limit;  ///< 1 for ratios, 0 for differences
    Side side;
    std::optional<double> published;  ///< the value of the paper's one example
    double (*valueOf)(const Trial &);

    bool holds(double value) const { return side == Side::Less ? value < limit : value > limit; }
};

const std::vector<Claim> &claims();

}  // namespace reproduce_papers
