#include "seahex/route/TurnComparison.h"

#include "seahex/route/RouteMetrics.h"
#include "seahex/search/AStar.h"
#include "seahex/search/HeadingGraph.h"
#include "seahex/search/JumpGraph.h"
#include "seahex/search/TurnWeight.h"

#include <algorithm>
#include <chrono>

namespace seahex
{
namespace
{

/// The price of a turn, in cells, at which paths of equal length are told apart and none else.
constexpr double leastPrice = 1e-5;

constexpr double equalLength = 1e-6;

/// The searches of one query.
class Comparison
{
public:
    Comparison(const Occupancy &occupancy, const Jumps &jumps, OffsetCoord start, OffsetCoord goal)
        : occupancy_(occupancy), jumps_(jumps), start_(start), goal_(goal)
    {
    }

    std::optional<MeasuredPath> plain() const
    {
        const Lattice &lattice = occupancy_.lattice();
        return lattice.hexagons() != nullptr ? plain<HexJumpNorm>(*lattice.hexagons())
                                             : plain<SquareJumpNorm>(*lattice.squares());
    }

    /// There must be a path.
    MeasuredPath priced(double perTurn) const
    {
        const Lattice &lattice = occupancy_.lattice();
        MeasuredPath path = lattice.hexagons() != nullptr ? *priced<HexJumpNorm>(*lattice.hexagons(), perTurn)
                                                          : *priced<SquareJumpNorm>(*lattice.squares(), perTurn);
        path.perTurn = perTurn;
        return path;
    }

private:
    template <class Norm>
    std::optional<MeasuredPath> plain(const typename Norm::KnownLattice &lattice) const
    {
        using Graph = JumpGraph<LatticeLengthWeight<Norm>>;
        return search<Graph>(
            [&]
            {
                return Graph(
                    occupancy_, jumps_, {{goal_, 0.0}},
                    {lattice, jumps_, LengthMetric::Euclidean, Guidance::Distance, centre(start_), centre(goal_)});
            },
            [](const Graph &, CellIndex cell) { return cell; }, [](const Graph &, CellIndex cell) { return cell; });
    }

    template <class Norm>
    std::optional<MeasuredPath> priced(const typename Norm::KnownLattice &lattice, double perTurn) const
    {
        using Cells = JumpGraph<LatticeTurnWeight<Norm>>;
        using Graph = HeadingGraph<Cells>;
        return search<Graph>(
            [&]
            {
                return Graph(Cells(occupancy_, jumps_, {{goal_, 0.0}},
                                   {lattice,
                                    jumps_,
                                    LengthMetric::Euclidean,
                                    {perTurn, 0.0},
                                    Guidance::Distance,
                                    centre(start_),
                                    centre(goal_)}));
            },
            [](const Graph &graph, CellIndex cell) { return graph.beginning(cell); },
            [](const Graph &graph, CellIndex state) { return graph.cellOf(state); });
    }

    Point centre(OffsetCoord cell) const { return occupancy_.lattice().centre(cell); }

    template <class Graph, class MakeGraph, class StateOf, class CellOf>
    std::optional<MeasuredPath> search(MakeGraph &&makeGraph, StateOf &&stateOf, CellOf &&cellOf) const
    {
        const auto begin = std::chrono::steady_clock::now();
        Graph graph = makeGraph();
        AStar<Graph> search(graph);
        search.addStart(stateOf(graph, occupancy_.layout().index(start_)), 0.0);
        search.run([] { return false; }, 1000000);
        const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begin;
        if (!search.hasPath())
            return std::nullopt;
        std::vector<Point> points;
        for (const CellIndex state : search.path())
            points.push_back(centre(occupancy_.layout().offset(cellOf(graph, state))));
        const RouteMetrics metrics = measureRoute(Route(points), occupancy_, CountedLegs::All);
        MeasuredPath path;
        path.lengthCells = metrics.lengthCells;
        path.turns = metrics.turns;
        path.turnAngleRad = metrics.turnAngleRad;
        path.expanded = search.counters().expanded;
        path.seconds = since.count();
        return path;
    }

    const Occupancy &occupancy_;
    const Jumps &jumps_;
    OffsetCoord start_;
    OffsetCoord goal_;
};

/// The corner of the hull with the fewest turns that is no longer than `longest`, between two of which the first is
/// and the second is not. Corners that are found are kept, in the order of turns, most first.
std::size_t cornerWithin(double longest, std::vector<MeasuredPath> &corners, const Comparison &comparison)
{
    for (;;)
    {
        const auto beyond = std::find_if(corners.begin(), corners.end(),
                                         [&](const MeasuredPath &path) { return path.lengthCells > longest; });
        const auto within = static_cast<std::size_t>(beyond - corners.begin()) - 1;
        if (beyond == corners.end() || corners[within].turns - beyond->turns <= 1)
            return within;
        const MeasuredPath &more = corners[within];
        const double price = (beyond->lengthCells - more.lengthCells) / (more.turns - beyond->turns);
        const MeasuredPath path = comparison.priced(price);
        if (path.turns >= more.turns || path.turns <= beyond->turns)
            return within;  // the two are neighbours on the hull
        corners.insert(beyond, path);
    }
}

}  // namespace

std::optional<TurnComparison> compareTurns(const Occupancy &occupancy, const Jumps &jumps, OffsetCoord start,
                                           OffsetCoord goal, const std::vector<double> &allowances)
{
    const Comparison comparison(occupancy, jumps, start, goal);
    const std::optional<MeasuredPath> plain = comparison.plain();
    if (!plain)
        return std::nullopt;
    TurnComparison result{*plain, {}};
    const double most = allowances.empty() ? 0.0 : allowances.back();
    std::vector<MeasuredPath> corners = {comparison.priced(leastPrice)};
    // No corner within the allowance needs a dearer turn: one turn saved is worth all of it.
    if (most > 0.0 && corners.front().turns > 0)
        if (const MeasuredPath last = comparison.priced(most * plain->lengthCells); last.turns < corners.front().turns)
            corners.push_back(last);
    for (const double allowance : allowances)
    {
        const double longest = std::max(plain->lengthCells * (1.0 + std::max(allowance, equalLength)),
                                        corners.front().lengthCells);  // however short the path
        result.fewest.push_back(corners[cornerWithin(longest, corners, comparison)]);
    }
    return result;
}

}  // namespace seahex
