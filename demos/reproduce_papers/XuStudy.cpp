#include "XuStudy.h"

#include "Quartiles.h"
#include "XuTrial.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <future>

namespace reproduce_papers
{
namespace
{

enum Method : std::size_t
{
    Greedy,
    GreedyOptimised,
    Exact,
    ExactOptimised,
    Ants,
    AntsOptimised
};

using Value = std::function<double(const MeasuredDive &)>;

/// A number of a dive.
struct Quantity
{
    const char *name;
    Value value;
    int decimals;
};

const std::vector<Quantity> &quantities()
{
    static const std::vector<Quantity> all = {
        {"length F1", [](const MeasuredDive &d) { return d.length; }, 2},
        {"danger F2", [](const MeasuredDive &d) { return d.danger; }, 3},
        {"F", [](const MeasuredDive &d) { return d.total; }, 3},
        {"course changes", [](const MeasuredDive &d) { return static_cast<double>(d.courseChanges); }, 0},
        {"course angles, degrees", [](const MeasuredDive &d) { return d.courseAngleDeg; }, 0},
        {"time, ms", [](const MeasuredDive &d) { return d.ms; }, 2}};
    return all;
}

/// What is said of one method against another, terrain by terrain.
struct Comparison
{
    const char *text;
    Method left;
    Method right;
    std::size_t quantity;
};

const std::vector<Comparison> &comparisons()
{
    static const std::vector<Comparison> all = {
        {"[Xu] length, greedy optimised - ants < 0", GreedyOptimised, Ants, 0},
        {"[Xu] course changes, greedy optimised - ants < 0", GreedyOptimised, Ants, 3},
        {"[Xu] course angles, greedy optimised - ants < 0", GreedyOptimised, Ants, 4},
        {"time, greedy optimised - ants < 0", GreedyOptimised, Ants, 5},
        {"danger, greedy optimised - ants < 0", GreedyOptimised, Ants, 1},
        {"F, greedy - ants < 0", Greedy, Ants, 2},
        {"length, greedy optimised - ants optimised < 0", GreedyOptimised, AntsOptimised, 0},
        {"F, exact - greedy < 0", Exact, Greedy, 2},
        {"F, exact - ants < 0", Exact, Ants, 2},
        {"F, exact optimised - greedy optimised < 0", ExactOptimised, GreedyOptimised, 2},
        {"length, exact optimised - ants optimised < 0", ExactOptimised, AntsOptimised, 0}};
    return all;
}

/// Every n-th terrain.
std::vector<XuTrial> runShare(const XuOptions &options, unsigned first, unsigned step)
{
    std::vector<XuTrial> trials;
    for (unsigned i = first; i < options.terrains; i += step)
        trials.push_back(runXuTrial(options.seed + i));
    return trials;
}

std::vector<XuTrial> runAll(const XuOptions &options)
{
    std::vector<std::future<std::vector<XuTrial>>> shares;
    for (unsigned i = 0; i < options.threads; ++i)
        shares.push_back(std::async(std::launch::async, runShare, options, i, options.threads));
    std::vector<XuTrial> trials(options.terrains);
    for (unsigned i = 0; i < options.threads; ++i)
    {
        std::vector<XuTrial> share = shares[i].get();
        for (std::size_t k = 0; k < share.size(); ++k)
            trials[i + k * options.threads] = std::move(share[k]);
    }
    return trials;
}

std::vector<double> valuesOf(const std::vector<XuTrial> &trials, std::size_t method, const Value &value)
{
    std::vector<double> values;
    for (const XuTrial &trial : trials)
        if (trial.isComplete())
            values.push_back(value(*trial.dives[method]));
    return values;
}

Table methodTable(const std::vector<XuTrial> &trials)
{
    const auto complete = std::count_if(trials.begin(), trials.end(), [](const XuTrial &t) { return t.isComplete(); });
    Table table;
    table.id = "xu_methods";
    table.title = "[Xu] 25 x 25 x 25 from [1, 8, 6] to [25, 23, 10], K = 0.5, on " + std::to_string(trials.size()) +
                  " random terrains";
    Table::Row found{"dives found", {}, 0};
    for (std::size_t method = 0; method < diveMethods.size(); ++method)
    {
        table.columns.push_back(diveMethods[method].name);
        const auto count = std::count_if(trials.begin(), trials.end(),
                                         [method](const XuTrial &t) { return t.dives[method].has_value(); });
        found.values.emplace_back(static_cast<double>(count));
    }
    table.rows.push_back(found);
    for (const Quantity &quantity : quantities())
    {
        Table::Row lower{std::string(quantity.name) + ", lower quartile", {}, quantity.decimals};
        Table::Row median{std::string(quantity.name) + ", median", {}, quantity.decimals};
        Table::Row upper{std::string(quantity.name) + ", upper quartile", {}, quantity.decimals};
        for (std::size_t method = 0; complete > 0 && method < diveMethods.size(); ++method)
        {
            const Quartiles quartiles = quartilesOf(valuesOf(trials, method, quantity.value));
            lower.values.emplace_back(quartiles.lower);
            median.values.emplace_back(quartiles.median);
            upper.values.emplace_back(quartiles.upper);
        }
        for (Table::Row *row : {&lower, &median, &upper})
        {
            row->values.resize(diveMethods.size());
            table.rows.push_back(*row);
        }
    }
    table.note = "Quartiles over the " + std::to_string(complete) +
                 " terrains on which all methods found a dive. Lengths are in vehicle lengths; course changes are "
                 "changes of\ndirection in space.";
    return table;
}

Table comparisonTable(const std::vector<XuTrial> &trials)
{
    Table table;
    table.id = "xu_claims";
    table.title = "[Xu] methods compared on each terrain";
    table.columns = {"terrains", "lower quartile", "median", "upper quartile", "holds %", "equal %"};
    table.decimals = {0, {}, {}, {}, 0, 0};
    for (const Comparison &comparison : comparisons())
    {
        const Value &value = quantities()[comparison.quantity].value;
        std::vector<double> differences;
        for (const XuTrial &trial : trials)
            if (trial.dives[comparison.left] && trial.dives[comparison.right])
                differences.push_back(value(*trial.dives[comparison.left]) - value(*trial.dives[comparison.right]));
        Table::Row row{comparison.text, {static_cast<double>(differences.size())}, 3};
        if (!differences.empty())
        {
            constexpr double same = 1e-9;
            const auto share = [&](auto &&isSo)
            {
                return 100.0 * static_cast<double>(std::count_if(differences.begin(), differences.end(), isSo)) /
                       static_cast<double>(differences.size());
            };
            const Quartiles quartiles = quartilesOf(differences);
            row.values.insert(row.values.end(), {quartiles.lower, quartiles.median, quartiles.upper,
                                                 share([](double d) { return d < -same; }),
                                                 share([](double d) { return std::abs(d) <= same; })});
        }
        row.values.resize(table.columns.size());
        table.rows.push_back(row);
    }
    table.note = "Over the terrains on which both methods found a dive. Lines with [Xu] are what the paper says.";
    return table;
}

SeabedFigure figureOf(const XuTrial &trial, std::size_t number)
{
    SeabedFigure figure;
    figure.name = "xu_figure";
    figure.content.seabed = trial.terrain;
    figure.content.exaggeration = 0.6;
    figure.content.unit = "vehicle lengths";
    figure.content.dives = {{trial.dives[Ants]->points, "ant colony", {0.95, 0.55, 0.0}},
                            {trial.dives[GreedyOptimised]->points, "greedy, optimised", {0.78, 0.0, 0.42}},
                            {trial.dives[ExactOptimised]->points, "exact, optimised", {0.10, 0.10, 0.12}}};
    char numbers[200];
    std::snprintf(numbers, sizeof numbers, "\nterrain %zu: F %.2f (ants), %.2f (greedy), %.2f (exact)", number,
                  trial.dives[Ants]->total, trial.dives[GreedyOptimised]->total, trial.dives[ExactOptimised]->total);
    figure.content.title = std::string("[Xu]: dives through slices of the water column") + numbers;
    return figure;
}

}  // namespace

Study xuStudy(const XuOptions &options)
{
    const std::vector<XuTrial> trials = runAll(options);
    Study study;
    study.tables = {methodTable(trials), comparisonTable(trials)};
    const auto shown = std::find_if(trials.begin(), trials.end(), [](const XuTrial &t) { return t.isComplete(); });
    if (shown != trials.end())
        study.seabeds.push_back(figureOf(*shown, static_cast<std::size_t>(shown - trials.begin()) + options.seed));
    return study;
}

}  // namespace reproduce_papers
