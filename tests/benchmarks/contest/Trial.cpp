#include "contest/Trial.h"

#include "contest/Median.h"
#include "contest/Queries.h"
#include "contest/Stopwatch.h"
#include "contest/TextbookAStar.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace seahex::contest
{
namespace
{

constexpr int mostRings = 3;

double sum(const std::vector<Answer> &answers, double (*of)(const Answer &))
{
    return std::accumulate(answers.begin(), answers.end(), 0.0,
                           [of](double total, const Answer &answer) { return total + of(answer); });
}

}  // namespace

Course::Course(World world, std::size_t queries, std::uint64_t seed)
    : world_(std::move(world)), queries_(drawQueries(*world_.occupancy, queries, seed)),
      costs_(mostRings, std::vector<std::optional<double>>(queries))
{
}

double &Course::expected(const ContenderKind &kind, std::size_t query, double cost)
{
    std::optional<double> &known = costs_[static_cast<std::size_t>(kind.rings - 1)][query];
    if (!known)
    {
        static const std::int64_t mostCells = contenderNamed("textbook_1").mostCells;
        known = world_.occupancy->lattice().cellCount() <= mostCells
                    ? TextbookAStar(*world_.occupancy, kind.rings).solve(queries_[query]).cost
                    : cost;
    }
    return *known;
}

void Course::check(const ContenderKind &kind, std::size_t query, double cost)
{
    const double reference = expected(kind, query, cost);
    constexpr double rounding = 1e-8;  // a search in whole numbers rounds the jumps' lengths
    if (std::abs(cost - reference) <= rounding * reference)
        return;
    throw std::runtime_error(kind.name + " on " + world_.name + ", query " + std::to_string(query) + ": cost " +
                             std::to_string(cost) + ", and " + std::to_string(reference) + " is right");
}

double Result::medianMs() const
{
    return medianOf(queryMs);
}

double Result::meanMs() const
{
    return std::accumulate(queryMs.begin(), queryMs.end(), 0.0) / static_cast<double>(queryMs.size());
}

double Result::expanded() const
{
    return sum(answers, [](const Answer &a) { return static_cast<double>(a.expanded); });
}

double Result::nsPerExpansion() const
{
    return 1e6 * meanMs() * static_cast<double>(queryMs.size()) / expanded();
}

double Result::bytesPerTouched() const
{
    const double touched = sum(answers, [](const Answer &a) { return static_cast<double>(a.touched); });
    return sum(answers, [](const Answer &a) { return static_cast<double>(a.memory.touched); }) / touched;
}

double Result::bitsPerIndex() const
{
    const double bytes = sum(answers, [](const Answer &a) { return static_cast<double>(a.memory.everywhere); });
    return 8.0 * bytes / static_cast<double>(answers.size()) / static_cast<double>(indices);
}

Trial::Trial(Course &course, const ContenderKind &kind)
    : course_(course), kind_(kind), contender_(kind.make(*course.world().occupancy))
{
    result_.world = course.world().name;
    result_.contender = kind.name;
    result_.side = kind.side;
    result_.rings = kind.rings;
    result_.cells = course.world().occupancy->lattice().cellCount();
    result_.indices = course.world().occupancy->layout().size();
    result_.queryMs.assign(course.queries().size(), std::numeric_limits<double>::infinity());
    result_.answers.resize(course.queries().size());
}

// A function of its own, so that a profiler can be told to look at nothing else.
[[gnu::noinline]] Answer Trial::solve(const Query &query)
{
    return contender_->solve(query);
}

double Trial::pass()
{
    double seconds = 0.0;
    for (std::size_t i = 0; i < course_.queries().size(); ++i)
    {
        const Stopwatch watch;
        result_.answers[i] = solve(course_.queries()[i]);
        const double taken = watch.seconds();
        seconds += taken;
        result_.queryMs[i] = std::min(result_.queryMs[i], 1e3 * taken);
        course_.check(kind_, i, result_.answers[i].cost);
    }
    return seconds;
}

}  // namespace seahex::contest
