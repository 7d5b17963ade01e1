// benchmark_planners as people run it, on tiny settings: files, database, page, continuing, shards, crashes, refusals.

#include "demos/PlanRoute.h"
#include "support/RunProgram.h"
#include "support/TestCharts.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <set>
#include <thread>

using namespace seahex::test;

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace
{

enum Code
{
    Usage = 2,
    BadChart = 3,
    NotNavigable = 4,
    NoReport = 7
};

ProgramResult benchmark(const Arguments &arguments)
{
    return runProgram(Arguments{SEAHEX_BENCHMARK_PLANNERS} + arguments);
}

/// Cells of 400 m and two pairs. The two planners stop by themselves, long before their time is over.
Arguments tiny(const fs::path &out, const std::string &pairs = "2",
               const std::string &planners = "HexAStar,RRTConnect+simplify", const std::string &seconds = "10")
{
    return {"--pitch", "400", "--time", seconds, "--pairs", pairs, "--planners", planners, "--out", out.string()};
}

/// All jobs are one shard: the page, which takes longest, is not made.
Arguments withoutPage()
{
    return {"--shard", "1/1"};
}

/// The rows of a query, as arrays.
Json query(const fs::path &database, const std::string &sql)
{
    const std::string script = "import json, sqlite3, sys\n"
                               "print(json.dumps(sqlite3.connect(sys.argv[1]).execute(sys.argv[2]).fetchall()))";
    const ProgramResult result = runProgram({"/usr/bin/python3", "-c", script, database.string(), sql});
    EXPECT_EQ(result.exitCode, 0) << result.summary();
    return Json::parse(result.out, nullptr, false);
}

const char *const runsSql =
    "SELECT pair, substr(plannerConfigs.name, 11), run, valid, length, legs, turns, turn_angle, "
    "least_clearance, time_to_first_solution, solve_time, best_known_cost, excess_percent, "
    "time_to_within_5_percent, time_to_within_1_percent, time_to_within_0_percent, distance, "
    "runs.id FROM runs JOIN experiments ON experiments.id = experimentid "
    "JOIN plannerConfigs ON plannerConfigs.id = plannerid ORDER BY 1, 2, 3";

std::string shown(const fs::path &file)
{
    return std::to_string(fs::file_size(file)) + " bytes of " + file.filename().string();
}

/// What a log's content and time were, to tell whether it was written again.
fs::file_time_type timeOf(const fs::path &file)
{
    return fs::last_write_time(file);
}

/// Processes of the program that work on a folder; with a name, those that have it (a job has its planner's).
std::vector<pid_t> processesOn(const fs::path &folder, const std::string &name = "")
{
    std::vector<pid_t> found;
    std::error_code ignored;
    for (const fs::directory_entry &entry : fs::directory_iterator("/proc", ignored))
    {
        const std::string number = entry.path().filename().string();
        if (number.find_first_not_of("0123456789") != std::string::npos)
            continue;
        std::ifstream commandLine(entry.path() / "cmdline");
        std::string command((std::istreambuf_iterator<char>(commandLine)), std::istreambuf_iterator<char>());
        std::string own;
        std::getline(std::ifstream(entry.path() / "comm"), own);
        if (command.rfind(SEAHEX_BENCHMARK_PLANNERS, 0) == 0 && command.find(folder.string()) != std::string::npos &&
            (name.empty() || own == name))
            found.push_back(std::stoi(number));
    }
    return found;
}

/// Waits until something holds; a minute at most.
bool waitFor(const std::function<bool()> &holds)
{
    for (int i = 0; i < 12000; ++i)
    {
        if (holds())
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

class BenchmarkPlanners : public testing::Test
{
protected:
    /// A run that must succeed.
    ProgramResult expectDone(const Arguments &arguments)
    {
        ProgramResult result = benchmark(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.summary();
        return result;
    }

    fs::path out() const { return folder_ / "out"; }
    fs::path log(const std::string &name) const { return out() / name; }

    TemporaryFolder folder_;
};

TEST_F(BenchmarkPlanners, writesDatabasePlotsAndPage)
{
    const ProgramResult result = expectDone(tiny(out()));
    for (const char *words : {"seed 1", "pair   1", "pair   2", "course", "HexAStar", "RRTConnect+simplify", "solved %",
                              "to 5 % ms", "index.html"})
        EXPECT_NE(result.out.find(words), std::string::npos) << words << " is not in\n" << result.out;

    for (const char *name : {"manifest.json", "pair-0001.json", "pair-0001.log", "pair-0002.log", "benchmark.db",
                             "cost_over_time.png", "cost_over_time_each.png", "speed.png", "quality.png"})
        EXPECT_TRUE(fs::exists(log(name))) << name;
    for (const fs::directory_entry &entry : fs::directory_iterator(out()))
        EXPECT_EQ(entry.path().string().find("part"), std::string::npos) << "left behind: " << entry.path();

    const std::string page = readBytes(log("index.html"));
    EXPECT_EQ(page.find("http://"), std::string::npos);
    EXPECT_EQ(page.find("https://"), std::string::npos);
    EXPECT_EQ(page.find("src=\"/"), std::string::npos);
    EXPECT_EQ(page.find(folder_.path().string()), std::string::npos);
    EXPECT_NE(page.find("data:image/svg+xml;base64,"), std::string::npos);
}

TEST_F(BenchmarkPlanners, databaseHoldsSaneMetricsOfEveryRun)
{
    expectDone(tiny(out(), "3", "HexAStar,HexAStar-1,RRTConnect+simplify,PRMstar", "0.3") + Arguments{"--runs", "2"});
    const Json runs = query(log("benchmark.db"), runsSql);
    ASSERT_EQ(runs.size(), 3u * 4u * 2u);
    std::map<int, double> least;
    for (const Json &run : runs)
    {
        SCOPED_TRACE(run.dump());
        if (run.at(3).is_null())  // no path in so short a time
            continue;
        EXPECT_EQ(run.at(3), 1);
        EXPECT_GE(run.at(4), run.at(16)) << "shorter than the straight line";
        EXPECT_LE(run.at(6), run.at(5)) << "more turns than legs";
        EXPECT_GE(run.at(7), 0.0);
        EXPECT_GT(run.at(8), 0.0);
        EXPECT_GT(run.at(9), 0.0);
        EXPECT_LE(run.at(9), run.at(10)) << "a first solution after the end";
        EXPECT_GE(run.at(4), run.at(11)) << "shorter than the best";
        EXPECT_NEAR(run.at(12).get<double>(), 100.0 * (run.at(4).get<double>() / run.at(11).get<double>() - 1.0), 1e-6);
        for (int column = 13; column < 15; ++column)
            EXPECT_TRUE(run.at(column + 1).is_null() || run.at(column) <= run.at(column + 1));
        EXPECT_EQ(run.at(13).is_null(), run.at(12) > 5.0001);
        const int pair = run.at(0);
        least[pair] = std::min(least.count(pair) > 0 ? least[pair] : 1e9, run.at(12).get<double>());
        const Json rows =
            query(log("benchmark.db"),
                  "SELECT time, best_cost FROM progress WHERE runid = " + run.at(17).dump() + " ORDER BY time");
        ASSERT_FALSE(rows.empty());
        EXPECT_EQ(rows.front().at(0), run.at(9));
        EXPECT_NEAR(rows.back().at(1).get<double>(), run.at(4).get<double>(), 1e-6);
        for (std::size_t i = 1; i < rows.size(); ++i)
            EXPECT_LE(rows[i].at(1), rows[i - 1].at(1)) << "a gain may be smaller than the digits written";
    }
    for (const auto &[pair, excess] : least)
        EXPECT_EQ(excess, 0.0) << "nobody holds the best known of pair " << pair;
    EXPECT_EQ(least.size(), 3u);
}

TEST_F(BenchmarkPlanners, continuesWithTheJobsWhoseLogsAreMissing)
{
    expectDone(tiny(out(), "3") + withoutPage());
    const auto first = timeOf(log("pair-0001.log"));
    const auto third = timeOf(log("pair-0003.log"));
    fs::remove(log("pair-0002.log"));

    const ProgramResult again = expectDone(tiny(out(), "3"));
    EXPECT_NE(again.err.find("2 of 3 jobs were done before"), std::string::npos) << again.summary();
    EXPECT_EQ(timeOf(log("pair-0001.log")), first);
    EXPECT_EQ(timeOf(log("pair-0003.log")), third);
    EXPECT_TRUE(fs::exists(log("pair-0002.log")));
    EXPECT_EQ(query(log("benchmark.db"), "SELECT count(*) FROM runs"), Json({{6}}));
}

TEST_F(BenchmarkPlanners, survivesBeingKilledInTheMiddle)
{
    const Arguments slow = tiny(out(), "4", "RRTstar", "0.4") + Arguments{"--jobs", "1"};
    std::thread killed([&] { EXPECT_EQ(benchmark(slow).signal, SIGKILL); });
    const bool isUnderWay = waitFor([&] { return fs::exists(log("pair-0001.json")); });
    const std::vector<pid_t> all = processesOn(out());
    if (!all.empty())
        kill(*std::min_element(all.begin(), all.end()), SIGKILL);  // the first process; its jobs go with it
    killed.join();
    ASSERT_TRUE(isUnderWay);
    ASSERT_FALSE(fs::exists(log("pair-0004.json"))) << "it had ended before it was killed";

    const auto first = timeOf(log("pair-0001.log"));
    expectDone(slow);
    EXPECT_EQ(timeOf(log("pair-0001.log")), first);
    EXPECT_EQ(query(log("benchmark.db"), "SELECT count(*) FROM runs"), Json({{4}}));
}

TEST_F(BenchmarkPlanners, noJobOutlivesTheProgram)
{
    const Arguments endless = tiny(out(), "1", "RRTstar", "600");
    std::thread killed([&] { EXPECT_EQ(benchmark(endless).signal, SIGKILL); });
    const bool isUnderWay = waitFor([&] { return !processesOn(out(), "RRTstar").empty(); });
    const std::vector<pid_t> all = processesOn(out());
    if (!all.empty())
        kill(*std::min_element(all.begin(), all.end()), SIGKILL);
    killed.join();
    EXPECT_TRUE(isUnderWay);
    EXPECT_TRUE(waitFor([&] { return processesOn(out()).empty(); }));
    for (const pid_t stray : processesOn(out()))
        kill(stray, SIGKILL);
}

TEST_F(BenchmarkPlanners, shardsMergeIntoWhatOneRunGives)
{
    const auto folder = [this](const char *name)
    {
        return folder_ / name;
    };
    expectDone(tiny(folder("whole"), "5"));
    for (const auto &[name, shard] : {std::pair("one", "1/2"), std::pair("two", "2/2")})
    {
        const ProgramResult result = expectDone(tiny(folder(name), "5") + Arguments{"--shard", shard});
        EXPECT_NE(result.out.find("--merge"), std::string::npos);
        EXPECT_FALSE(fs::exists(folder(name) / "index.html"));
        expectDone(tiny(folder("shared"), "5") + Arguments{"--shard", shard});
    }
    EXPECT_TRUE(fs::exists(folder("one") / "pair-0005.log"));
    EXPECT_FALSE(fs::exists(folder("one") / "pair-0002.log"));
    EXPECT_FALSE(fs::exists(folder("two") / "pair-0005.log"));

    const std::string merged = folder("merged").string();
    expectDone({"--merge", folder("one").string(), folder("two").string(), "--out", merged});
    expectDone({"--merge", "--out", folder("shared").string()});
    EXPECT_TRUE(fs::exists(folder("merged") / "index.html"));
    const char *const sql = "SELECT pair, plannerConfigs.name, run, CASE plannerConfigs.name WHEN 'geometric_HexAStar' "
                            "THEN length END FROM runs JOIN experiments ON experiments.id = experimentid "
                            "JOIN plannerConfigs ON plannerConfigs.id = plannerid ORDER BY 1, 2, 3";
    const Json whole = query(folder("whole") / "benchmark.db", sql);
    EXPECT_EQ(whole.size(), 10u);
    EXPECT_EQ(query(folder("merged") / "benchmark.db", sql), whole);
    EXPECT_EQ(query(folder("shared") / "benchmark.db", sql), whole);
}

TEST_F(BenchmarkPlanners, refusesAFolderOfOtherSettings)
{
    expectDone(tiny(out(), "1") + withoutPage());
    const auto before = timeOf(log("pair-0001.log"));
    for (const auto &[option, value, words] :
         {std::tuple("--seed", "2", "seed is 1 there and 2 here"), std::tuple("--runs", "3", "runs is 1 there and 3"),
          std::tuple("--draught", "9", "arena.draught_m is 1.2 there and 9")})
    {
        const ProgramResult result = benchmark(tiny(out(), "1") + Arguments{option, value});
        EXPECT_EQ(result.exitCode, Usage) << result.summary();
        EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    }
    EXPECT_EQ(timeOf(log("pair-0001.log")), before);

    expectDone(tiny(folder_ / "other", "1") + withoutPage() + Arguments{"--seed", "2"});
    const ProgramResult merged = benchmark({"--merge", out().string(), (folder_ / "other").string()});
    EXPECT_EQ(merged.exitCode, Usage) << merged.summary();
    EXPECT_NE(merged.err.find("seed is 1 in one and 2 in the other"), std::string::npos) << merged.err;
}

TEST_F(BenchmarkPlanners, aPlannerThatCrashesCostsItsOwnResultsOnly)
{
    // A job's process bears the name of the planner at work; here it is killed, as by a crash, both times it shows.
    const Arguments slow = tiny(out(), "1", "HexAStar,RRTstar,BITstar", "1");
    ProgramResult result;
    std::thread running([&] { result = benchmark(slow); });
    std::set<pid_t> ended;
    const bool areEnded = waitFor(
        [&]
        {
            for (const pid_t process : processesOn(out(), "RRTstar"))
                if (ended.insert(process).second)
                    kill(process, SIGKILL);
            return ended.size() == 2;
        });
    running.join();
    ASSERT_TRUE(areEnded);
    EXPECT_EQ(result.exitCode, 0) << result.summary();
    for (const std::string &text : {result.out, result.err})
        EXPECT_NE(text.find("Killed"), std::string::npos) << result.summary();
    EXPECT_TRUE(fs::exists(log("pair-0001-HexAStar.log")));
    EXPECT_TRUE(fs::exists(log("pair-0001-BITstar.log")));
    EXPECT_FALSE(fs::exists(log("pair-0001-RRTstar.log")));
    EXPECT_EQ(query(log("benchmark.db"), "SELECT pair, planner, how FROM crashes"), Json({{1, "RRTstar", "Killed"}}));
    EXPECT_EQ(query(log("benchmark.db"), "SELECT count(*) FROM runs"), Json({{2}}));
    EXPECT_NE(readBytes(log("index.html")).find("Killed"), std::string::npos);

    const Json report = Json::parse(benchmark(slow + Arguments{"--json"}).out, nullptr, false);
    ASSERT_TRUE(report.is_object());
    EXPECT_EQ(report.at("planners").at(1).at("crashed"), 1);
    EXPECT_EQ(report.at("planners").at(1).at("solved"), 0);
    EXPECT_TRUE(report.at("planners").at(1).at("excess_percent").at("median").is_null());
}

TEST_F(BenchmarkPlanners, jsonIsOneObjectWithSettingsPairsAndResults)
{
    const ProgramResult result = expectDone(tiny(out()) + Arguments{"--json"});
    const Json report = Json::parse(result.out, nullptr, false);
    ASSERT_TRUE(report.is_object()) << result.out;
    EXPECT_EQ(report.at("status"), "success");
    EXPECT_EQ(report.at("settings").at("seed"), 1);
    EXPECT_EQ(report.at("settings").at("pair_list").size(), 2u);
    EXPECT_EQ(report.at("pairs_done"), Json({1, 2}));
    ASSERT_EQ(report.at("planners").size(), 2u);
    EXPECT_EQ(report.at("planners").at(0).at("planner"), "HexAStar");
    EXPECT_EQ(report.at("planners").at(0).at("solved"), 2);
    EXPECT_EQ(result.out.find(folder_.path().string()), std::string::npos);
}

TEST_F(BenchmarkPlanners, helpNamesEveryOptionAndHowToShareTheWork)
{
    const ProgramResult result = expectDone({"--help"});
    for (const char *word : {"--chart",    "--draught",
                             "--ukc",      "--margin",
                             "--pitch",    "--planners",
                             "--pairs",    "--runs",
                             "--time",     "--least-distance",
                             "--seed",     "--jobs",
                             "--shard",    "--out",
                             "--merge",    "--json",
                             "Exit codes", "parallel ",
                             "sbatch",     "SLURM_ARRAY_TASK_ID",
                             "HexAStar-1", "RRTConnect+simplify",
                             "AITstar"})
        EXPECT_NE(result.out.find(word), std::string::npos) << word;
}

TEST_F(BenchmarkPlanners, refusesInOneSentence)
{
    const auto expectRefusal = [this](Arguments arguments, Code code, const std::string &words)
    {
        SCOPED_TRACE(testing::PrintToString(arguments));
        arguments = arguments + Arguments{"--out", out().string()};
        const ProgramResult text = benchmark(arguments);
        EXPECT_EQ(text.exitCode, code) << text.summary();
        EXPECT_EQ(text.out, "");
        EXPECT_EQ(text.err.rfind("benchmark_planners: error: ", 0), 0u) << text.err;
        EXPECT_EQ(std::count(text.err.begin(), text.err.end(), '\n'), 1) << text.err;
        EXPECT_NE(text.err.find(words), std::string::npos) << text.err;
        const Json json = Json::parse(benchmark(arguments + Arguments{"--json"}).out, nullptr, false);
        ASSERT_TRUE(json.is_object());
        EXPECT_EQ(json.at("exit"), static_cast<int>(code));
        EXPECT_FALSE(fs::exists(log("pair-0001.log")));
    };
    expectRefusal({"--sail"}, Usage, "--sail");
    expectRefusal({"--planners", "HexAStar,Dijkstra"}, Usage, "no planner 'Dijkstra'; known are HexAStar, ");
    for (const char *shard : {"0/2", "3/2", "1", "a/b", "1/2/3", "-1/2", "1/0", "1/2x", ""})
        expectRefusal({"--shard", shard}, Usage, "--shard must be I/N");
    expectRefusal({"--pairs", "0"}, Usage, "--pairs must lie between 1 and");
    expectRefusal({"--runs", "0"}, Usage, "--runs must lie between 1 and");
    expectRefusal({"--jobs", "0"}, Usage, "--jobs must lie between 1 and");
    expectRefusal({"--time", "nan"}, Usage, "--time must lie between");
    expectRefusal({"--time", "-1"}, Usage, "--time must lie between");
    expectRefusal({"--least-distance", "2"}, Usage, "--least-distance must lie between");
    expectRefusal({"--draught", "-1"}, Usage, "--draught must be 0 or more");
    expectRefusal({"--pitch", "wide"}, Usage, "--pitch must be a positive number");
    expectRefusal({"--merge", "--shard", "1/2"}, Usage, "--shard has no meaning");
    expectRefusal({"--merge"}, Usage, "manifest.json");
    expectRefusal({"--chart", (folder_ / "none.000").string()}, BadChart, "none.000");
    expectRefusal({"--pitch", "400", "--least-distance", "0.9"}, NotNavigable, "a smaller --least-distance may help");

    writeBytes(folder_ / "file", "");
    const ProgramResult file = benchmark(tiny(folder_ / "file"));
    EXPECT_EQ(file.exitCode, Usage) << file.summary();
    EXPECT_NE(file.err.find("can't make the folder"), std::string::npos) << file.err;
}

/// Sets an environment variable until the end of the scope.
class Environment
{
public:
    Environment(const char *name, const std::string &value) : name_(name)
    {
        if (const char *old = std::getenv(name))
            old_ = old;
        setenv(name, value.c_str(), 1);
    }
    ~Environment() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }
    Environment(const Environment &) = delete;
    Environment &operator=(const Environment &) = delete;

private:
    const char *name_;
    std::optional<std::string> old_;
};

TEST_F(BenchmarkPlanners, aMissingPackageCostsThePageAndNotTheLogs)
{
    {
        const Environment noTools("PATH", "/nowhere");
        const ProgramResult result = benchmark(tiny(out(), "1"));
        EXPECT_EQ(result.exitCode, NoReport) << result.summary();
        EXPECT_NE(result.err.find("install the Debian package ompl-demos"), std::string::npos) << result.err;
        EXPECT_TRUE(fs::exists(log("pair-0001.log")));
    }
    {
        // A module of matplotlib's name that is none.
        writeBytes(folder_ / "matplotlib.py", "raise ImportError('none')\n");
        const Environment noMatplotlib("PYTHONPATH", folder_.path().string());
        const ProgramResult result = benchmark({"--merge", out().string()});
        EXPECT_EQ(result.exitCode, NoReport) << result.summary();
        EXPECT_NE(result.err.find("python3-matplotlib is missing"), std::string::npos) << result.err;
        EXPECT_NE(result.out.find("HexAStar"), std::string::npos) << "the table needs no matplotlib";
        EXPECT_TRUE(fs::exists(log("benchmark.db"))) << shown(out());
    }
    expectDone({"--merge", out().string()});
    EXPECT_TRUE(fs::exists(log("index.html")));
}

TEST_F(BenchmarkPlanners, runsOnAnyChart)
{
    const fs::path chart = folder_ / "tiny.gpkg";
    writeTinyChart(chart, false);
    // No hazard but the coverage's edge, which the line between start and goal touches.
    expectDone(tiny(out(), "1") + Arguments{"--chart", chart.string()});
    EXPECT_EQ(query(log("benchmark.db"), "SELECT count(*) FROM runs WHERE valid AND least_clearance IS NULL"),
              Json({{2}}));
    expectDone(Arguments{"--chart", sanya(), "--draught", "3"} +
               tiny(folder_ / "sanya", "1", "HexAStar,BITstar", "0.3"));
    EXPECT_EQ(query(folder_ / "sanya" / "benchmark.db", "SELECT count(*) FROM runs"), Json({{2}}));
}

}  // namespace
