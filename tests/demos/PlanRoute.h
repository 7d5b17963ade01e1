#pragma once

#include "support/ChartOracle.h"
#include "support/RunProgram.h"
#include "support/TestCharts.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace seahex::test
{

using Arguments = std::vector<std::string>;

inline Arguments operator+(Arguments left, const Arguments &right)
{
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

/// The project's own charts, and two positions that lie in one water of each.
inline std::string shangchuan()
{
    return (std::filesystem::path(SEAHEX_MAPS_DIR) / "shangchuan.000").string();
}
inline std::string sanya()
{
    return (std::filesystem::path(SEAHEX_MAPS_DIR) / "sanya.000").string();
}

/// Across Shangchuan's waters: around the island, for the straight line crosses it.
inline Arguments aroundShangchuan()
{
    return {"--chart", shangchuan(), "--from", "21.635,112.521", "--to", "21.669,112.901"};
}

inline ProgramResult planRoute(const Arguments &arguments)
{
    return runProgram(Arguments{SEAHEX_PLAN_ROUTE} + arguments);
}

/// The report of a run that must find a route; null (and a failed test) if it does not.
inline nlohmann::json routeReport(const Arguments &arguments)
{
    const ProgramResult result = planRoute(arguments + Arguments{"--json"});
    EXPECT_EQ(result.exitCode, 0) << result.summary();
    EXPECT_EQ(result.err, "");
    return result.exitCode == 0 ? nlohmann::json::parse(result.out, nullptr, false) : nlohmann::json();
}

/// The waypoints of the report's "raw" or "smoothed".
inline std::vector<LatLon> waypoints(const nlohmann::json &route)
{
    std::vector<LatLon> positions;
    for (const nlohmann::json &p : route.at("waypoints"))
        positions.emplace_back(p.at(0).get<double>(), p.at(1).get<double>());
    return positions;
}

/// Neither route of the report touches anything that the judge forbids.
inline void expectSafe(const nlohmann::json &report, const ChartOracle &oracle)
{
    ASSERT_TRUE(report.is_object());
    for (const char *name : {"raw", "smoothed"})
    {
        if (report.at(name).is_null())
            continue;
        const std::vector<LatLon> route = waypoints(report.at(name));
        EXPECT_GE(route.size(), 2u);
        for (const Violation &violation : oracle.violationsWithin(route, 9.9))
            ADD_FAILURE() << name << ", leg " << violation.leg << ": " << violation.what;
    }
}

/// A chart of our own making: 10 m of water from 30 to 30.1 E and 40 to 40.1 N, parted into halves by a wall of land
/// 0.01 degrees wide if so wanted.
inline void writeTinyChart(const std::filesystem::path &path, bool withWall)
{
    const TestFeature west{boxWkt(30.0, 40.0, 30.04, 40.1), {{"DRVAL1", 10.0}, {"DRVAL2", 20.0}}};
    const TestFeature middle{boxWkt(30.04, 40.0, 30.05, 40.1), {{"DRVAL1", 10.0}, {"DRVAL2", 20.0}}};
    const TestFeature east{boxWkt(30.05, 40.0, 30.1, 40.1), {{"DRVAL1", 10.0}, {"DRVAL2", 20.0}}};
    const TestFeature wall{boxWkt(30.04, 40.0, 30.05, 40.1), {}};
    std::vector<TestLayer> layers = {{"M_COVR", {{boxWkt(30.0, 40.0, 30.1, 40.1), {{"CATCOV", 1}}}}}};
    layers.push_back(
        {"DEPARE", withWall ? std::vector<TestFeature>{west, east} : std::vector<TestFeature>{west, middle, east}});
    if (withWall)
        layers.push_back({"LNDARE", {wall}});
    writeChart(path, layers);
}

}  // namespace seahex::test
