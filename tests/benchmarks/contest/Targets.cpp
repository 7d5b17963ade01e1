#include "contest/Targets.h"

#include "contest/Median.h"

#include <algorithm>
#include <iomanip>

namespace seahex::contest
{
namespace
{

using Value = std::optional<Target::Value>;
using Measure = std::function<Value(const Measurements &)>;

/// How many times faster than the peer: the median over the queries of the ratio of their times.
double speedUp(const Result &peer, const Result &ours)
{
    std::vector<double> ratios;
    for (std::size_t i = 0; i < ours.queryMs.size(); ++i)
        ratios.push_back(peer.queryMs[i] / ours.queryMs[i]);
    return medianOf(std::move(ratios));
}

/// The fastest of ours with so many rings against a peer.
Measure fastest(const std::string &world, int rings, const std::string &peer)
{
    return [=](const Measurements &measured) -> Value
    {
        const Result *other = measured.find(world, peer);
        Value best;
        for (const Result &result : measured.results)
            if (other != nullptr && result.world == world && result.rings == rings && result.side == Side::Ours)
                if (const double ratio = speedUp(*other, result); !best || ratio > best->value)
                    best = Target::Value{ratio, result.contender};
        return best;
    };
}

/// What the most modest of ours with so many rings takes.
Measure least(const std::string &world, int rings, double (*of)(const Result &))
{
    return [=](const Measurements &measured) -> Value
    {
        Value best;
        for (const Result &result : measured.results)
            if (result.world == world && result.rings == rings && result.side == Side::Ours)
                if (const double value = of(result); !best || value < best->value)
                    best = Target::Value{value, result.contender};
        return best;
    };
}

Measure figure(const std::string &name)
{
    return [=](const Measurements &measured) -> Value
    {
        const auto found = measured.figures.find(name);
        return found == measured.figures.end() ? Value() : Target::Value{found->second, ""};
    };
}

/// One figure as a share of another.
Measure ratio(const std::string &name, const std::string &base)
{
    return [=](const Measurements &measured) -> Value
    {
        const auto found = measured.figures.find(name);
        const auto whole = measured.figures.find(base);
        if (found == measured.figures.end() || whole == measured.figures.end())
            return std::nullopt;
        return Target::Value{found->second / whole->second, ""};
    };
}

/// The least figure of ours with so many rings, by the contender's name after a prefix.
Measure leastFigure(const std::string &prefix, int rings)
{
    return [=](const Measurements &measured) -> Value
    {
        Value best;
        for (const ContenderKind &kind : contenders())
        {
            const auto found = measured.figures.find(prefix + kind.name);
            if (kind.side == Side::Ours && kind.rings == rings && found != measured.figures.end() &&
                (!best || found->second < best->value))
                best = Target::Value{found->second, kind.name};
        }
        return best;
    };
}

double worstStateMB(const Result &result)
{
    double worst = 0.0;
    for (const Answer &answer : result.answers)
        worst = std::max(worst, 1e-6 * static_cast<double>(answer.memory.everywhere + answer.memory.touched));
    return worst;
}

double bytesPerTouched(const Result &result)
{
    return result.bytesPerTouched();
}

double bitsPerIndex(const Result &result)
{
    return result.bitsPerIndex();
}

const char *verdictOf(const Target &target, const Value &value)
{
    if (!value)
        return "not measured";
    const bool met = target.aim == Aim::AtLeast ? value->value >= target.target : value->value <= target.target;
    return met ? "met" : "missed";
}

}  // namespace

const Result *Measurements::find(const std::string &world, const std::string &contender) const
{
    for (const Result &result : results)
        if (result.world == world && result.contender == contender)
            return &result;
    return nullptr;
}

void Measurements::noteLeast(const std::string &name, double value)
{
    const auto [known, isNew] = figures.emplace(name, value);
    if (!isNew)
        known->second = std::min(known->second, value);
}

const std::vector<Target> &targets()
{
    static const std::vector<Target> all = {
        {"N, ring 1, times as fast as the textbook", Aim::AtLeast, 60, "x", fastest("N", 1, "textbook_1")},
        {"N, ring 1, the stretch", Aim::AtLeast, 120, "x", fastest("N", 1, "textbook_1")},
        {"N, ring 3, times as fast as the textbook of ring 3", Aim::AtLeast, 30, "x", fastest("N", 3, "textbook_3")},
        {"N, ring 3, times as fast as the textbook of ring 1", Aim::AtLeast, 30, "x", fastest("N", 3, "textbook_1")},
        {"N, ring 1, times as fast as Boost.Graph", Aim::AtLeast, 1, "x", fastest("N", 1, "boost_1")},
        {"N, ring 1, bytes a touched cell", Aim::AtMost, 6, "B", least("N", 1, bytesPerTouched)},
        {"N, ring 3, bytes a touched cell", Aim::AtMost, 6, "B", least("N", 3, bytesPerTouched)},
        {"N, ring 1, bits an untouched cell", Aim::AtMost, 2, "bit", least("N", 1, bitsPerIndex)},
        {"N, ring 3, bits an untouched cell", Aim::AtMost, 2, "bit", least("N", 3, bitsPerIndex)},
        {"N100, ring 3, state of the search", Aim::AtMost, 100, "MB", least("N100", 3, worstStateMB)},
        {"N, ring 1, instructions an expansion", Aim::AtMost, 250, "", leastFigure("instructions/N/", 1)},
        {"N, ring 3, instructions an expansion", Aim::AtMost, 350, "", leastFigure("instructions/N/", 3)},
        {"P, first path after set-up", Aim::AtMost, 0.4, "ms", figure("first/P/HexAStar")},
        {"N, first path after set-up", Aim::AtMost, 0.4, "ms", figure("first/N/HexAStar")},
        {"P, cost over time, moments at which a planner of OMPL's is ahead", Aim::AtMost, 0, "", figure("behind/P")},
        {"N, cost over time, moments at which a planner of OMPL's is ahead", Aim::AtMost, 0, "", figure("behind/N")},
        {"S, median query to the proven optimum", Aim::AtMost, 10, "ms", figure("exact/S/taut")},
        {"P, median query to the proven optimum", Aim::AtMost, 1000, "ms", figure("exact/P/taut")},
        {"N, median query to the proven optimum", Aim::AtMost, 1000, "ms", figure("exact/N/taut")},
        {"N, gap of three rings pulled taut, median", Aim::AtMost, 0.02, "%", figure("gap/N/median")},
        {"N, gap of three rings pulled taut, worst", Aim::AtMost, 0.5, "%", figure("gap/N/worst")},
        {"N, batch on two cores, times as fast as on one", Aim::AtLeast, 1.8, "x", figure("batch/N")},
        {"N, replanning, share of a fresh search's time", Aim::AtMost, 0.1, "x", figure("replan/N")},
        {"N, filling, share of gdal_rasterize's time", Aim::AtMost, 0.3, "x", ratio("fill/N/hexagons", "fill/N/gdal")},
        {"N100, filling, share of gdal_rasterize's time", Aim::AtMost, 0.3, "x",
         ratio("fill/N100/hexagons", "fill/N100/gdal")},
        {"opening a chart, times GDAL's reading of its layers", Aim::AtMost, 1.3, "x",
         ratio("open/N/seahex", "open/N/gdal")},
    };
    return all;
}

void printVerdicts(const Measurements &measurements, std::ostream &out)
{
    out << '\n'
        << std::left << std::setw(68) << "what decides" << std::right << std::setw(12) << "measured" << std::setw(12)
        << "target"
        << "  verdict\n";
    for (const Target &target : targets())
    {
        const Value value = target.measure(measurements);
        out << std::left << std::setw(68) << target.what << std::right << std::setw(12);
        if (value)
            out << std::setprecision(3) << value->value;
        else
            out << "-";
        out << std::setw(4) << (target.aim == Aim::AtLeast ? ">=" : "<=") << ' ' << std::setw(4) << target.target << ' '
            << std::left << std::setw(3) << target.unit << "  " << verdictOf(target, value);
        if (value && !value->by.empty())
            out << " (" << value->by << ')';
        out << '\n';
    }
}

}  // namespace seahex::contest
