#include "support/conformance/Footing.h"
#include "support/conformance/Themes.h"
#include "support/conformance/Trial.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

// Names and parameters, as configuration files and logs of benchmarks use them.

std::map<std::string, std::string> valuesOf(const ob::Planner &planner)
{
    std::map<std::string, std::string> values;
    planner.params().getParams(values);
    return values;
}

/// Numbers compared as such, so that 0.5 is 0.500000.
bool isSame(const std::string &a, const std::string &b)
{
    static const std::regex number("[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?");
    if (std::regex_match(a, number) && std::regex_match(b, number))
        return std::stod(a) == std::stod(b);
    return a == b;
}

std::vector<std::string> split(const std::string &text, char separator)
{
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);)
        parts.push_back(part);
    return parts;
}

/// @return false if the value was refused, by exception (OMPL's own for a number that is none) or by setParam()
bool trySet(ob::Planner &planner, const std::string &name, const std::string &value)
{
    try
    {
        return planner.params().setParam(name, value);
    }
    catch (const std::runtime_error &)
    {
        return false;
    }
}

void namesFitALog(Trial &trial)
{
    const auto planner = trial.planner();
    const auto fits = [](const std::string &name)
    {
        return !name.empty() && name.find_first_of(";|\n\r") == std::string::npos;
    };
    trial.expect(fits(planner->getName()), "the name " + inQuotes(planner->getName()) + " does not fit a log");
    for (const auto &[name, value] : valuesOf(*planner))
    {
        trial.expect(fits(name) && fits(value), "the parameter " + inQuotes(name) + " does not fit a log");
        trial.expect(std::regex_match(name, std::regex("[A-Za-z][A-Za-z0-9_.]*")),
                     "the parameter " + inQuotes(name) + " is no identifier");
    }
    std::ostringstream printed;
    planner->printProperties(printed);
    planner->printSettings(printed);
    trial.expect(printed.str().find(planner->getName()) != std::string::npos, "the name is not printed");
}

/// "0,1", "a,b,c", "first:last" or "first:step:last", and the value is one of them or in between.
bool isWithin(const std::string &value, const std::string &range)
{
    const std::vector<std::string> choices = split(range, ',');
    if (choices.size() > 1)
        return std::any_of(choices.begin(), choices.end(), [&](const auto &choice) { return isSame(choice, value); });
    const std::vector<std::string> ends = split(range, ':');
    if (ends.size() != 2 && ends.size() != 3)
        return false;
    std::size_t read = 0;
    for (const std::string &end : ends)
        if (std::stod(end, &read); read != end.size())
            return false;
    return std::stod(value) >= std::stod(ends.front()) && std::stod(value) <= std::stod(ends.back());
}

void valuesAreTakenBack(Trial &trial)
{
    const auto planner = trial.planner();
    for (const auto &[name, value] : valuesOf(*planner))
    {
        trial.expect(trySet(*planner, name, value), inQuotes(name) + " refuses its own value " + inQuotes(value));
        trial.expect(isSame(planner->params()[name].getValue(), value),
                     inQuotes(name) + " was " + inQuotes(value) + ", and after that was set " +
                         inQuotes(planner->params()[name].getValue()));
    }
}

void rangesHoldTheValues(Trial &trial)
{
    const auto planner = trial.planner();
    for (const auto &[name, value] : valuesOf(*planner))
    {
        const std::string range = planner->params()[name].getRangeSuggestion();
        trial.expect(range.empty() || isWithin(value, range),
                     inQuotes(name) + " is " + inQuotes(value) + ", not in " + inQuotes(range));
    }
}

/// The first and the last of a range, and each of a list.
void everythingInTheRangesIsTaken(Trial &trial)
{
    for (const auto &[name, value] : valuesOf(*trial.planner()))
    {
        const std::string range = trial.planner()->params()[name].getRangeSuggestion();
        std::vector<std::string> choices = split(range, ',');
        if (choices.size() == 1)
        {
            choices = split(range, ':');
            choices = {choices.front(), choices.back()};
        }
        for (const std::string &choice : choices)
        {
            const auto planner = trial.planner();
            trial.expect(trySet(*planner, name, choice) && isSame(planner->params()[name].getValue(), choice),
                         inQuotes(name) + " does not take " + inQuotes(choice));
        }
    }
}

void badValuesAreRefused(Trial &trial)
{
    const auto refuses = [&](const std::string &name, const std::string &bad)
    {
        const auto planner = trial.planner();
        const auto before = valuesOf(*planner);
        if (!trial.expect(before.count(name) == 1, "there is no parameter " + inQuotes(name)))
            return;
        trial.expect(!trySet(*planner, name, bad), inQuotes(name) + " takes " + inQuotes(bad));
        trial.expect(valuesOf(*planner) == before, inQuotes(name) + " refuses " + inQuotes(bad) + " and is changed");
    };
    for (const auto &[name, bad] : trial.subject().refusedSettings)
        refuses(name, bad);
    const auto planner = trial.planner();
    for (const auto &parameter : valuesOf(*planner))
        if (planner->params()[parameter.first].getRangeSuggestion() != "0,1")  // any word is true for OMPL
            refuses(parameter.first, "no such value");
    trial.expect(!trySet(*planner, "no_such_parameter", "1"), "a parameter that does not exist is set");
}

void settingsStay(Trial &trial)
{
    const auto planner = trial.planner();
    const auto before = valuesOf(*planner);
    const auto expectKept = [&](const std::string &when)
    {
        for (const auto &[name, value] : valuesOf(*planner))
            trial.expect(before.at(name) == value,
                         inQuotes(name) + " was " + inQuotes(before.at(name)) + ", " + when + " " + inQuotes(value));
    };
    planner->setProblemDefinition(trial.problem('A', 'B'));
    planner->setup();
    expectKept("after setup");
    trial.mustSolve(planner, "solve");
    expectKept("after solve");
    planner->clear();
    expectKept("after clear");
}

/// A planner that can't plan in every space says so at once.
void aForeignSpaceIsRefused(Trial &trial)
{
    const auto refuses = [&](const ob::SpaceInformationPtr &si, const std::string &what)
    {
        try
        {
            const auto planner = trial.subject().make(si);
            trial.expect(false, what + ": no ompl::Exception");
        }
        catch (const ompl::Exception &)
        {
        }
    };
    refuses(nullptr, "no space");
    const unsigned int foreign = Footing(trial.si()->getStateSpace().get()).isSolid() ? 2 : 3;
    const auto space = std::make_shared<ob::RealVectorStateSpace>(foreign);
    space->setBounds(0.0, 1.0);
    refuses(std::make_shared<ob::SpaceInformation>(space), "R^" + std::to_string(foreign));
}

}  // namespace

std::vector<PlannerCheck> settingChecks()
{
    return {
        {"NamesFitALog", namesFitALog},
        {"ValuesAreTakenBack", valuesAreTakenBack},
        {"RangesHoldTheValues", rangesHoldTheValues},
        {"EverythingInTheRangesIsTaken", everythingInTheRangesIsTaken},
        {"BadValuesAreRefused", badValuesAreRefused},
        {"SettingsStay", settingsStay},
        {"AForeignSpaceIsRefused", aForeignSpaceIsRefused},
    };
}

}  // namespace seahex::test
