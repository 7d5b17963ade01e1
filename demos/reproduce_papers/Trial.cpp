#include "Trial.h"

#include <seahex/route/RouteSmoother.h>
#include <seahex/search/HexJumps.h>

namespace reproduce_papers
{
namespace
{

using seahex::Guidance;
using seahex::JumpRule;

/// Plans on one pair; remembers whether there was always a path.
class Trials
{
public:
    Trials(const Sea &sea, const demos::Pair &pair) : sea_(sea), pair_(pair) {}

    bool foundAll() const { return foundAll_; }

    Run run(const Method &method, seahex::Route *path = nullptr)
    {
        const auto answer = sea_.plan(method, pair_.start, pair_.goal);
        if (!answer)
        {
            foundAll_ = false;
            return {};
        }
        if (path != nullptr)
            *path = answer->path;
        return {measurePath(sea_, method.cells, answer->path), static_cast<double>(answer->counters.expanded),
                answer->searchMs};
    }

    Run run(const Method &method, Measured &pulled)
    {
        seahex::Route path;
        const Run result = run(method, &path);
        if (!path.empty())
            pulled = pull(method.cells, path);
        return result;
    }

    Trial::Wang wang(const Method &method)
    {
        Trial::Wang result;
        result.dijkstra = run(with(method, Guidance::None));
        result.aStar = run(with(method, Guidance::Euclidean));
        seahex::Route path;
        result.improved = run(with(with(method, Cost::Sailing), Guidance::Wang), &path);
        if (path.empty())
            return result;
        result.smoothed = measureSmoothed(sea_, method.cells, smoothedAsPublished(sea_, method.cells, path));
        result.withMargin = measureSmoothed(sea_, method.cells, smoothedWithMargin(sea_, method.cells, path));
        result.pulled = pull(method.cells, path);
        return result;
    }

    Trial::Turns turns(int rings)
    {
        const seahex::Occupancy &occupancy = sea_.occupancy(Cells::Hexagons);
        const seahex::HexJumps jumps(occupancy.layout(), rings, seahex::JumpSet::All);
        const seahex::Lattice &lattice = occupancy.lattice();
        const auto comparison = seahex::compareTurns(occupancy, jumps, lattice.cellAt(pair_.start),
                                                     lattice.cellAt(pair_.goal), {0.0, 0.02});
        if (!comparison)
        {
            foundAll_ = false;
            return {};
        }
        return {comparison->plain, comparison->fewest[0], comparison->fewest[1]};
    }

private:
    Measured pull(Cells cells, const seahex::Route &path) const
    {
        return measureSmoothed(sea_, cells, seahex::pullString(path, sea_.occupancy(cells)));
    }

    const Sea &sea_;
    const demos::Pair &pair_;
    bool foundAll_ = true;
};

}  // namespace

std::optional<Trial> runTrial(const Sea &sea, const demos::Pair &pair)
{
    Trials trials(sea, pair);
    Trial trial;
    trial.hex6 = trials.run(hexagons(1), trial.pulledHex6);
    trial.hex18 = trials.run(hexagons(2));
    trial.hex36 = trials.run(hexagons(3), trial.pulledHex36);
    trial.square8 = trials.run(squares(), trial.pulledSquare8);
    trial.square8OfArea = trials.run(squares(Cells::SquaresOfArea));
    trial.relaxedHex6 = trials.run(with(hexagons(1), Guidance::Relaxed));
    trial.relaxedHex36 = trials.run(with(hexagons(3), Guidance::Relaxed));
    trial.guidedHex6 = trials.run(with(hexagons(1), Guidance::Cheng));
    trial.guidedSquare8 = trials.run(with(squares(), Guidance::Cheng));
    trial.stepsHex36 = trials.run(with(hexagons(3), Cost::Steps));
    trial.hoppingHex36 = trials.run(with(with(hexagons(3), Cost::Steps), JumpRule::Hopping));
    const auto asPublished = [](const Method &method)
    {
        return with(with(method, Cost::Steps), Guidance::Cheng);
    };
    trial.publishedHex6 = trials.run(asPublished(hexagons(1)));
    trial.publishedHex18 = trials.run(asPublished(hexagons(2)));
    trial.publishedHex36 = trials.run(asPublished(hexagons(3)));
    trial.turnsHex6 = trials.turns(1);
    trial.turnsHex36 = trials.turns(3);
    trial.squares = trials.wang(squares());
    trial.hexagons = trials.wang(hexagons(1));
    return trials.foundAll() ? std::optional<Trial>(trial) : std::nullopt;
}

}  // namespace reproduce_papers
