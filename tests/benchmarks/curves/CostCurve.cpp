#include "curves/CostCurve.h"

#include "contest/Median.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seahex::contest
{
namespace
{

constexpr double never = std::numeric_limits<double>::infinity();

std::map<std::size_t, double> bestCosts(const std::vector<PlannerRun> &runs)
{
    std::map<std::size_t, double> best;
    for (const PlannerRun &run : runs)
        for (const benchmark_planners::TimedCost &next : run.improvements)
        {
            const auto [known, isNew] = best.emplace(run.query, next.cost);
            if (!isNew)
                known->second = std::min(known->second, next.cost);
        }
    return best;
}

double costAt(const PlannerRun &run, double seconds)
{
    double cost = never;
    for (const benchmark_planners::TimedCost &next : run.improvements)
        if (next.seconds <= seconds)
            cost = next.cost;
    return cost;
}

double timeTo(const PlannerRun &run, double cost)
{
    for (const benchmark_planners::TimedCost &next : run.improvements)
        if (next.cost <= cost)
            return next.seconds;
    return never;
}

}  // namespace

std::vector<double> timeGrid(double limitS)
{
    std::vector<double> moments;
    for (int k = 0;; ++k)
    {
        const double moment = 1e-4 * std::pow(10.0, 0.1 * k);
        if (moment > limitS * (1.0 + 1e-9))
            return moments;
        moments.push_back(moment);
    }
}

std::map<std::string, std::vector<double>> medianCurves(const std::vector<PlannerRun> &runs,
                                                        const std::vector<double> &moments)
{
    const auto best = bestCosts(runs);
    std::map<std::string, std::vector<double>> curves;
    for (const double moment : moments)
    {
        std::map<std::string, std::vector<double>> ratios;
        for (const PlannerRun &run : runs)
        {
            const double cost = costAt(run, moment);
            ratios[run.planner].push_back(std::isinf(cost) ? never : cost / best.at(run.query));
        }
        for (auto &[planner, values] : ratios)
            curves[planner].push_back(medianOf(std::move(values)));
    }
    return curves;
}

double medianTimeTo(const std::vector<PlannerRun> &runs, const std::string &planner, double ratio)
{
    const auto best = bestCosts(runs);
    std::vector<double> times;
    for (const PlannerRun &run : runs)
        if (run.planner == planner)
            times.push_back(run.improvements.empty() ? never : timeTo(run, ratio * best.at(run.query)));
    return medianOf(std::move(times));
}

std::size_t momentsBehind(const std::map<std::string, std::vector<double>> &curves, const std::string &ours)
{
    const std::vector<double> &own = curves.at(ours);
    std::size_t behind = 0;
    for (std::size_t i = 0; i < own.size(); ++i)
        behind += std::any_of(curves.begin(), curves.end(),
                              [&](const auto &other) { return other.second[i] * (1.0 + 1e-9) < own[i]; })
                      ? 1
                      : 0;
    return behind;
}

}  // namespace seahex::contest
