#pragma once

#include "support/ExplicitGraph.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace seahex::test
{

/// A window of lattice points where nothing is in the way, with the least costs from its middle to each of them, jump
/// by jump, by Boost.Graph's Dijkstra: what norms are held against. For chains that stay within 20 of the middle.
class OpenWindow
{
public:
    /// A jump by two coordinates in which the lattice looks the same from everywhere.
    struct Jump
    {
        std::int64_t first;
        std::int64_t second;
        double cost;
    };

    explicit OpenWindow(const std::vector<Jump> &jumps)
    {
        ExplicitGraph graph(static_cast<std::size_t>(width * width));
        for (std::int64_t i = -half; i <= half; ++i)
            for (std::int64_t j = -half; j <= half; ++j)
                for (const Jump &jump : jumps)
                    if (std::abs(i + jump.first) <= half && std::abs(j + jump.second) <= half)
                        graph.addEdge(vertex(i, j), vertex(i + jump.first, j + jump.second), jump.cost);
        costs_ = graph.costsFrom({{vertex(0, 0), 0.0}});
    }

    double costTo(std::int64_t first, std::int64_t second) const { return costs_[vertex(first, second)]; }

private:
    static constexpr std::int64_t half = 20;
    static constexpr std::int64_t width = 2 * half + 1;

    static std::size_t vertex(std::int64_t i, std::int64_t j)
    {
        return static_cast<std::size_t>((j + half) * width + i + half);
    }

    std::vector<double> costs_;
};

}  // namespace seahex::test
