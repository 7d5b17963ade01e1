#pragma once

#include <seahex/chart/Chart.h>
#include <seahex/chart/ChartArena.h>
#include <seahex/chart/WrittenRouteCheck.h>

#include <memory>

namespace benchmark_planners
{

/// What all jobs share, made once and only read from then on.
struct World
{
    World(std::shared_ptr<const seahex::Chart> readChart, std::shared_ptr<const seahex::ChartArena> madeArena)
        : chart(std::move(readChart)), arena(std::move(madeArena)), check(*chart, *arena)
    {
    }

    std::shared_ptr<const seahex::Chart> chart;
    std::shared_ptr<const seahex::ChartArena> arena;
    seahex::WrittenRouteCheck check;
};

}  // namespace benchmark_planners
