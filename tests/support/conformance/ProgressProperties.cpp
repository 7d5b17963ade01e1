#include "support/conformance/Themes.h"
#include "support/conformance/Trial.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <regex>
#include <thread>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

// Progress properties, which tools::Benchmark reads from a thread of its own whenever it likes.

/// True if a property "words TYPE" makes a column of a database, and the text a value of that type.
bool isColumn(const std::string &property)
{
    static const std::regex form("[A-Za-z][A-Za-z0-9]*( [A-Za-z0-9]+)* (REAL|INTEGER|BOOLEAN)");
    return std::regex_match(property, form);
}

bool isValue(const std::string &property, const std::string &text)
{
    static const std::regex real("[+-]?([0-9]+\\.?[0-9]*([eE][+-]?[0-9]+)?|inf|nan)");
    static const std::regex integer("[+-]?[0-9]+");
    static const std::regex boolean("0|1|true|false");
    const std::string type = property.substr(property.rfind(' ') + 1);
    return std::regex_match(text, type == "REAL" ? real : type == "INTEGER" ? integer : boolean);
}

/// Reads every property. @return the values; faults are noted
std::map<std::string, std::string> readAll(Trial &trial, const ob::Planner &planner, const std::string &when)
{
    std::map<std::string, std::string> values;
    for (const auto &[name, getter] : planner.getPlannerProgressProperties())
    {
        values[name] = getter();
        trial.expect(isValue(name, values[name]), when + ": " + inQuotes(name) + " is " + inQuotes(values[name]));
    }
    return values;
}

double realOf(const std::map<std::string, std::string> &values, const std::string &name)
{
    const auto value = values.find(name);
    return value == values.end() ? std::numeric_limits<double>::quiet_NaN() : std::stod(value->second);
}

void propertiesAreColumns(Trial &trial)
{
    const auto planner = trial.planner();
    const auto &properties = planner->getPlannerProgressProperties();
    for (const auto &property : properties)
        trial.expect(isColumn(property.first), inQuotes(property.first) + " is not of the form 'words TYPE'");
    for (const std::string &name : trial.subject().progress)
        trial.expect(properties.count(name) == 1, "there is no " + inQuotes(name));
}

void propertiesMayBeReadAtAnyTime(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner();
    readAll(trial, *planner, "before there is a problem");
    planner->setProblemDefinition(problem);
    readAll(trial, *planner, "before setup");
    planner->setup();
    readAll(trial, *planner, "after setup");
    trial.solve(planner, ob::plannerAlwaysTerminatingCondition(), "no time");
    readAll(trial, *planner, "after no time");
    trial.mustSolve(planner, "solve");
    readAll(trial, *planner, "after solve");
    planner->clear();
    readAll(trial, *planner, "after clear");
    trial.mustSolve(planner, "solve");
    planner->clearQuery();
    readAll(trial, *planner, "after clearQuery");
}

void theBestCostIsTheSolutions(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    trial.expect(!std::isfinite(realOf(readAll(trial, *planner, "before solve"), "best cost REAL")),
                 "there is a best cost before solve");
    for (int i = 0; i < 2; ++i)
    {
        const double cost = trial.mustSolve(planner, "solve");
        const auto values = readAll(trial, *planner, "after solve");
        const double best = realOf(values, "best cost REAL");
        // six decimals are what std::to_string gives
        trial.expect(std::abs(best - cost) <= 1e-6 * std::max(1.0, cost),
                     "best cost " + toText(best) + ", and the solution's is " + toText(cost));
        if (values.count("lower bound REAL") > 0)
            trial.expect(realOf(values, "lower bound REAL") <= cost + 1e-6 * std::max(1.0, cost),
                         "the lower bound " + values.at("lower bound REAL") + " is above the cost " + toText(cost));
    }
    planner->clear();
    trial.expect(!std::isfinite(realOf(readAll(trial, *planner, "after clear"), "best cost REAL")),
                 "the best cost survives clear");
}

/// A thread that reads all the time, from before setup to after the last clear. What it read is looked at afterwards.
void propertiesMayBeReadFromAnotherThread(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner();
    std::atomic<bool> over{false};
    std::atomic<int> round{0};  // odd while there is a solve() that began after clear()
    std::map<std::string, std::string> oddValues;
    bool rose = false;
    std::thread reader(
        [&]
        {
            double best = std::numeric_limits<double>::infinity();
            for (int last = 0; !over;)
                for (const auto &[name, getter] : planner->getPlannerProgressProperties())
                {
                    const int before = round;
                    const std::string value = getter();
                    if (!isValue(name, value))
                        oddValues[name] = value;
                    else if (name == "best cost REAL" && before % 2 == 1 && round == before)
                    {
                        best = before == last ? best : std::numeric_limits<double>::infinity();
                        last = before;
                        rose = rose || std::stod(value) > best;
                        best = std::stod(value);
                    }
                }
        });
    const auto ask = [&](const std::string &when)
    {
        if (!planner->isSetup())
            planner->setup();
        ++round;
        trial.mustSolve(planner, when);
        ++round;
        problem->clearSolutionPaths();
    };
    try
    {
        planner->setProblemDefinition(problem);
        for (int i = 0; i < 5; ++i)
        {
            ask("read while solving");
            ask("read while solving again");
            planner->clear();
        }
    }
    catch (...)
    {
        over = true;
        reader.join();
        throw;
    }
    over = true;
    reader.join();
    for (const auto &[name, value] : oddValues)
        trial.expect(false, "read while solving: " + inQuotes(name) + " is " + inQuotes(value));
    trial.expect(!rose, "read while solving: the best cost rises");
}

}  // namespace

std::vector<PlannerCheck> progressChecks()
{
    return {
        {"PropertiesAreColumns", propertiesAreColumns},
        {"PropertiesMayBeReadAtAnyTime", propertiesMayBeReadAtAnyTime},
        {"TheBestCostIsTheSolutions", theBestCostIsTheSolutions},
        {"PropertiesMayBeReadFromAnotherThread", propertiesMayBeReadFromAnotherThread},
    };
}

}  // namespace seahex::test
