#include "ClaimsStudy.h"

#include "Quartiles.h"
#include "common/Arena.h"
#include "common/Failure.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <future>

namespace reproduce_papers
{
namespace
{

using seahex::HexLattice;
using seahex::SquareLattice;

std::shared_ptr<const seahex::ChartArena> makeArena(const std::string &path)
{
    return demos::makeArena(*demos::readChart({path}), {});
}

double pitchFor(const seahex::ChartArena &arena, double cells)
{
    const seahex::Box box = arena.occupancy()->lattice().bounds();
    const seahex::Point extent = box.max - box.min;
    return std::sqrt(extent.x() * extent.y() / cells / (0.5 * std::sqrt(3.0)));
}

Sea makeSea(const seahex::ChartArena &arena, double pitch)
{
    const seahex::Box box = arena.occupancy()->lattice().bounds();
    return Sea(arena, HexLattice::covering(box, pitch), SquareLattice::covering(box, pitch));
}

std::vector<demos::Pair> drawPairs(const Sea &sea, const ClaimsOptions &options, double leastDistance)
{
    demos::PairRules rules;
    rules.count = options.pairs;
    rules.leastDistance = leastDistance;
    rules.seed = options.seed;
    rules.needsDetour = true;
    return demos::drawPairs(
        {&sea.occupancy(Cells::Hexagons), &sea.occupancy(Cells::Squares), &sea.occupancy(Cells::SquaresOfArea)}, rules);
}

/// Every n-th pair, on a sea of its own.
std::vector<std::optional<Trial>> runShare(const Sea &sea, const std::vector<demos::Pair> &pairs, std::size_t first,
                                           std::size_t step)
{
    std::vector<std::optional<Trial>> trials;
    for (std::size_t i = first; i < pairs.size(); i += step)
        trials.push_back(runTrial(sea, pairs[i]));
    return trials;
}

ChartTrials runOn(const std::string &path, const ClaimsOptions &options)
{
    const auto arena = makeArena(path);
    ChartTrials result;
    result.chart = std::filesystem::path(path).stem().string();
    result.pitchM = pitchFor(*arena, options.cells);
    std::vector<demos::Pair> pairs;
    constexpr int mostRefinements = 3;
    for (int i = 0; pairs.empty(); ++i)
    {
        const Sea sea = makeSea(*arena, result.pitchM);
        result.cells = static_cast<std::size_t>(sea.occupancy(Cells::Hexagons).lattice().cellCount());
        try
        {
            pairs = drawPairs(sea, options, result.leastDistance);
        }
        catch (const demos::Failure &failure)
        {
            if (i == mostRefinements)
                throw demos::Failure(failure.exit(), path + ": " + failure.what());
            result.pitchM *= std::sqrt(0.5);
            result.leastDistance *= 0.75;
        }
    }
    std::vector<std::future<std::vector<std::optional<Trial>>>> shares;
    for (unsigned k = 0; k < options.threads; ++k)
        shares.push_back(std::async(std::launch::async,
                                    [&, k]
                                    {
                                        const Sea sea = makeSea(*arena, result.pitchM);
                                        return runShare(sea, pairs, k, options.threads);
                                    }));
    for (auto &share : shares)
        for (const std::optional<Trial> &trial : share.get())
            if (trial)
                result.trials.push_back(*trial);
            else
                ++result.leftOut;
    return result;
}

std::vector<double> valuesOf(const Claim &claim, const ChartTrials &chart)
{
    std::vector<double> values;
    for (const Trial &trial : chart.trials)
        values.push_back(claim.valueOf(trial));
    return values;
}

double shareHolding(const Claim &claim, const std::vector<double> &values)
{
    const auto holding = std::count_if(values.begin(), values.end(), [&](double value) { return claim.holds(value); });
    return static_cast<double>(holding) / static_cast<double>(values.size());
}

Table chartTable(const std::vector<ChartTrials> &charts)
{
    Table table;
    table.id = "charts";
    table.title = "Charts of the random pairs";
    table.columns = {"hexagons", "pitch, m", "squares of_area, m", "least distance, %", "pairs", "left out"};
    for (const ChartTrials &chart : charts)
        table.rows.push_back({chart.chart,
                              {static_cast<double>(chart.cells), chart.pitchM, edgeOfEqualArea(chart.pitchM),
                               100.0 * chart.leastDistance, static_cast<double>(chart.trials.size()),
                               static_cast<double>(chart.leftOut)},
                              0});
    table.note = "Squares of equal spacing have the hexagons' pitch as edge, those of equal area the edge above.\n"
                 "Least distance between start and goal: of the diagonal. Left out: no path on one of the lattices.";
    return table;
}

Table::Row rowOf(const Claim &claim, const std::vector<ChartTrials> &charts)
{
    std::vector<double> pooled;
    double chartsHolding = 0.0;
    for (const ChartTrials &chart : charts)
    {
        const std::vector<double> values = valuesOf(claim, chart);
        if (values.empty())
            continue;
        pooled.insert(pooled.end(), values.begin(), values.end());
        chartsHolding += claim.holds(quartilesOf(values).median) ? 1.0 : 0.0;
    }
    const Quartiles quartiles = quartilesOf(pooled);
    const char *side = claim.side == Claim::Side::Less ? " < " : " > ";
    return {claim.text + side + demos::plain(claim.limit),
            {claim.published, quartiles.lower, quartiles.median, quartiles.upper, 100.0 * shareHolding(claim, pooled),
             chartsHolding},
            claim.limit == 0.0 ? 1 : 3};
}

/// A table for each source of claims.
std::vector<Table> tablesOfClaims(const std::vector<ChartTrials> &charts)
{
    std::vector<Table> tables;
    for (const Claim &claim : claims())
    {
        if (tables.empty() || tables.back().id != claim.source)
        {
            Table table;
            table.id = claim.source;
            table.title = "Claims of " + claim.source + ", over all random pairs";
            table.columns = {"published",      "lower quartile", "median",
                             "upper quartile", "holds %",        "charts of_" + std::to_string(charts.size())};
            table.decimals = {{}, {}, {}, {}, 0, 0};
            tables.push_back(table);
        }
        tables.back().rows.push_back(rowOf(claim, charts));
    }
    for (Table &table : tables)
        table.note =
            "Holds: for so many of the pairs; on so many charts in the median. Published: of the paper's one example.";
    return tables;
}

}  // namespace

std::vector<ChartTrials> runTrials(const ClaimsOptions &options, demos::Progress &progress)
{
    std::vector<ChartTrials> charts;
    for (const std::string &path : options.charts)
    {
        progress.stage(std::to_string(options.pairs) + " pairs on " + std::filesystem::path(path).filename().string());
        charts.push_back(runOn(path, options));
    }
    return charts;
}

std::vector<Table> claimTables(const std::vector<ChartTrials> &charts)
{
    std::vector<Table> tables = {chartTable(charts)};
    for (const Table &table : tablesOfClaims(charts))
        tables.push_back(table);
    return tables;
}

nlohmann::ordered_json claimsJson(const std::vector<ChartTrials> &charts)
{
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Claim &claim : claims())
    {
        nlohmann::ordered_json perChart = nlohmann::ordered_json::array();
        for (const ChartTrials &chart : charts)
        {
            const std::vector<double> values = valuesOf(claim, chart);
            if (values.empty())
                continue;
            const Quartiles quartiles = quartilesOf(values);
            perChart.push_back({{"chart", chart.chart},
                                {"pairs", values.size()},
                                {"lower_quartile", quartiles.lower},
                                {"median", quartiles.median},
                                {"upper_quartile", quartiles.upper},
                                {"holds_share", shareHolding(claim, values)},
                                {"holds", claim.holds(quartiles.median)}});
        }
        all.push_back({{"id", claim.id},
                       {"source", claim.source},
                       {"claim", claim.text},
                       {"side", claim.side == Claim::Side::Less ? "less" : "more"},
                       {"limit", claim.limit},
                       {"charts", perChart}});
    }
    return all;
}

}  // namespace reproduce_papers
