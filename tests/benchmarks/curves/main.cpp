// Cost over time of HexAStar and OMPL's planners on the contest's worlds and queries: the longer half of the benchmark
// that decides. Leaves the curves in a table (CSV) and what the verdicts want to know in a file of figures.

#include "contest/Figures.h"
#include "contest/Options.h"
#include "contest/Trial.h"
#include "curves/CostCurve.h"

#include <benchmark_planners/Roster.h>
#include <seahex/planning/Setup.h>

#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>

namespace
{

using namespace seahex::contest;
namespace og = ompl::geometric;

const char *const ours = "HexAStar";

/// The roster's, without HexAStar's parts and AIT*, whose 1.5.2 is no usable baseline.
std::vector<std::string> plannerNames()
{
    std::vector<std::string> names;
    for (const std::string &name : benchmark_planners::rosterNames())
        if (name.rfind("HexAStar-", 0) != 0 && name != "AITstar")
            names.push_back(name);
    return names;
}

PlannerRun runOnce(const Course &course, std::size_t query, const std::string &name, double limitS)
{
    const auto &occupancy = course.world().occupancy;
    const seahex::HexLattice &lattice = occupancy->lattice();
    og::SimpleSetup setup(seahex::planarSpace(*occupancy));
    seahex::useOccupancy(setup, occupancy);
    seahex::setStartAndGoal(setup, lattice.centre(course.queries()[query].start),
                            lattice.centre(course.queries()[query].goal));
    const auto planner = benchmark_planners::makeFromRoster(name, setup.getSpaceInformation());
    planner->setTimeLimit(limitS);
    setup.setPlanner(planner);
    setup.setup();
    planner->solve(ompl::base::plannerNonTerminatingCondition());
    PlannerRun run{query, name, {}};
    if (!setup.haveExactSolutionPath())
        return run;
    if (!setup.getSolutionPath().check())
        throw std::runtime_error(name + " returned a path that is not valid");
    benchmark_planners::CostHistory history = planner->history();
    history.finish(planner->wallSeconds(), setup.getSolutionPath().length());
    run.improvements = history.improvements();
    return run;
}

std::vector<PlannerRun> runAll(const Course &course, const Options &options)
{
    std::vector<PlannerRun> runs;
    for (std::size_t query = 0; query < course.queries().size(); ++query)
        for (const std::string &name : plannerNames())
            for (std::size_t i = 0; i < options.runs; ++i)
                runs.push_back(runOnce(course, query, name, options.limitS));
    return runs;
}

void print(const std::string &world, const std::vector<PlannerRun> &runs,
           const std::map<std::string, std::vector<double>> &curves)
{
    constexpr double any = std::numeric_limits<double>::infinity();
    std::cout << '\n'
              << world << ": medians" << std::setw(26) << "first path, ms" << std::setw(12) << "to 5 %, ms"
              << std::setw(12) << "to 1 %, ms" << std::setw(14) << "at the end, %\n";
    for (const auto &[planner, curve] : curves)
        std::cout << std::setw(22) << std::left << planner << std::right << std::setprecision(3) << std::setw(14)
                  << 1e3 * medianTimeTo(runs, planner, any) << std::setw(12) << 1e3 * medianTimeTo(runs, planner, 1.05)
                  << std::setw(12) << 1e3 * medianTimeTo(runs, planner, 1.01) << std::setw(13)
                  << 100.0 * (curve.back() - 1.0) << '\n';
    std::cout << ours << " is behind at " << momentsBehind(curves, ours) << " of " << curves.begin()->second.size()
              << " moments" << std::endl;
}

}  // namespace

int main(int argc, char **argv)
try
{
    const Options options = readOptions({argv + 1, argv + argc});
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(options.seed);
    const std::vector<double> moments = timeGrid(options.limitS);
    std::ofstream table("curves.csv");
    table << "world,planner,seconds,ratio\n";
    auto figures = readFigures("curves.json");
    for (const std::string &world : options.worlds)
    {
        if (!isAvailable(world))
        {
            std::cerr << world << ": skipped, its chart was not found (SEAHEX_TEST_DATA)\n";
            continue;
        }
        const Course course(makeWorld(world), options.queries, options.seed);
        const std::vector<PlannerRun> runs = runAll(course, options);
        const auto curves = medianCurves(runs, moments);
        print(world, runs, curves);
        for (const auto &[planner, curve] : curves)
            for (std::size_t i = 0; i < moments.size(); ++i)
                table << world << ',' << planner << ',' << moments[i] << ',' << curve[i] << '\n';
        figures["behind/" + world] = static_cast<double>(momentsBehind(curves, ours));
    }
    writeFigures(figures, "curves.json");
    return table.flush() ? 0 : 1;
}
catch (const std::exception &error)
{
    std::cerr << error.what() << '\n';
    return 2;
}
