#pragma once

#include <seahex/geometry/Point3.h>
#include <seahex/world/Bathymetry.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reproduce_papers
{

/// How a dive through slices is planned.
struct DiveMethod
{
    enum class Search
    {
        Greedy,  ///< [Xu] eq. 6-9
        Exact,   ///< least F
        Ants
    };

    std::string name;
    Search search;
    bool isOptimised;  ///< points dropped afterwards, as [Xu] does
};

/// In this order everywhere.
inline const std::array<DiveMethod, 6> diveMethods{{{"greedy", DiveMethod::Search::Greedy, false},
                                                    {"greedy optimised", DiveMethod::Search::Greedy, true},
                                                    {"exact", DiveMethod::Search::Exact, false},
                                                    {"exact optimised", DiveMethod::Search::Exact, true},
                                                    {"ants", DiveMethod::Search::Ants, false},
                                                    {"ants optimised", DiveMethod::Search::Ants, true}}};

/// A dive's numbers by the paper's measures.
struct MeasuredDive
{
    std::vector<seahex::Point3> points;
    double length = 0.0;          ///< F1, vehicle lengths
    double danger = 0.0;          ///< F2
    double total = 0.0;           ///< F
    int courseChanges = 0;        ///< changes of direction in space
    double courseAngleDeg = 0.0;  ///< their sum
    double ms = 0.0;              ///< to plan it
};

/// One terrain and what came of it, in the order of diveMethods; empty where no dive was found.
struct XuTrial
{
    std::shared_ptr<const seahex::Bathymetry> terrain;  ///< z counts down from height 25
    std::array<std::optional<MeasuredDive>, diveMethods.size()> dives;

    bool isComplete() const;
};

/// The paper's experiment, 25 x 25 x 25 from [1, 8, 6] to [25, 23, 10] with K = 0.5, on the hills of a seed.
XuTrial runXuTrial(std::uint32_t seed);

}  // namespace reproduce_papers
