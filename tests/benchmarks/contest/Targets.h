#pragma once

#include "contest/Trial.h"

#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace seahex::contest
{

/// All that a run of the benchmark measured.
struct Measurements
{
    std::vector<Result> results;
    /// Figures that are no searches, by name: "fill/N/hexagons". Times are the least of all passes.
    std::map<std::string, double> figures;

    /// Notes a time where it is less than the one known.
    void noteLeast(const std::string &name, double value);

    const Result *find(const std::string &world, const std::string &contender) const;
};

enum class Aim
{
    AtLeast,
    AtMost
};

/// One line of the verdict.
struct Target
{
    struct Value
    {
        double value;
        std::string by;  ///< which contender, or what else there is to say
    };

    std::string what;
    Aim aim;
    double target;
    std::string unit;  ///< "x", "ms", ...
    std::function<std::optional<Value>(const Measurements &)> measure;
};

/// Every line that decides, and what is asked of it: the one place for both.
const std::vector<Target> &targets();

/// Prints every line with its value, its target and "met", "missed" or "not measured".
void printVerdicts(const Measurements &measurements, std::ostream &out);

}  // namespace seahex::contest
