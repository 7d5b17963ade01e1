#include "support/conformance/PlannerArena.h"

#include "support/AsciiWorld.h"
#include "support/CellOracle.h"
#include "support/conformance/Footing.h"

#include <seahex/planning/OccupancyMotionValidator.h>
#include <seahex/planning/OccupancyValidityChecker.h>

#include <algorithm>
#include <set>
#include <utility>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

/// The free cells that can be reached from one of them. Of squares those that share an edge will do: a diagonal step
/// needs both cells beside it.
std::set<OffsetCoord> flooded(const Occupancy &occupancy, OffsetCoord from)
{
    const Lattice &lattice = occupancy.lattice();
    std::set<OffsetCoord> reached = {from};
    std::vector<OffsetCoord> open = {from};
    while (!open.empty())
    {
        const OffsetCoord cell = open.back();
        open.pop_back();
        for (const OffsetCoord &next : lattice.neighbours(cell))
        {
            const bool isBeside = lattice.hexagons() != nullptr || next.column == cell.column || next.row == cell.row;
            if (isBeside && occupancy.isFree(next) && reached.insert(next).second)
                open.push_back(next);
        }
    }
    return reached;
}

PlannerArena onChart(const std::string &name, const std::shared_ptr<const Occupancy> &chart)
{
    PlannerArena arena;
    arena.name = name;
    arena.bounds = chart->lattice().bounds();
    arena.chart = chart;
    arena.places['O'] = arena.bounds.max + Point(3, 3);
    return arena;
}

template <class World>
PlannerArena drawn(const std::string &name, const std::string &letters, const std::string &picture)
{
    const World world(picture, 1.0, Point(-7, 30));
    PlannerArena arena = onChart(name, world.shared());
    for (const char letter : letters)
        arena.places[letter] = world.centre(letter);
    forEachCell(world.lattice(), 0,
                [&](typename World::Cell cell)
                {
                    if (world.occupancy().isBlocked(cell))
                        arena.places['X'] = world.lattice().centre(cell);
                });
    return arena;
}

PlannerArena bay()
{
    return drawn<AsciiWorld>("bay", "ABCDE", R"(
         A . . # . . . . . # . .
        . . . # . . # # . . # C
         . # . . . # E # . . . .
        . # # . . . # # . # # .
         . . # # # . . . . # . .
        # . . . . . # # . . . .
         . . # # . D . # # # . .
        . . . # . . . # . . . B
    )");
}

/// With corners that a diagonal step would cut.
PlannerArena squareBay()
{
    return drawn<SquareWorld>("square bay", "ABCDE", R"(
        A . . # . . . . . # . .
        . . . # . . # # # . # C
        . # . . . . # E # . . .
        . # # . . . # # # # # .
        . . . # # . . . . # . .
        # . . . . . # # . . . .
        . . # # . D . # # # . .
        . . . # . . . # . . . B
    )");
}

PlannerArena strait()
{
    return drawn<AsciiWorld>("strait", "ABCDE", R"(
         A . . . # # # # # # . . . C
        . . . . # # # # # # . . . .
         . . . . . . . . . . . . . .
        . . . . # # # # # # . . . .
         D . . . # # E # # # . . . B
    )");
}

PlannerArena squareStrait()
{
    return drawn<SquareWorld>("square strait", "ABCDE", R"(
        A . . . # # # # # # . . . C
        . . . . # # # # # # . . . .
        . . . . . . . . . . . . . .
        . . . . # # # # # # . . . .
        D . . . # # E # # # . . . B
    )");
}

PlannerArena openWater()
{
    return drawn<AsciiWorld>("open", "ABCD", R"(
         A . . . . . . .
        . . . . . . . C
         . . . . . . . .
        . D . . . . . .
         . . . . . . . B
    )");
}

/// Cells of 2, a fifth of them blocked, and places that are no centres of cells.
template <class LatticeType>
PlannerArena archipelago(const std::string &name, std::int64_t columns)
{
    Random random(22);
    const auto chart = randomOccupancy(random, LatticeType(Point(100, 50), 2.0, columns, columns), 0.22);
    PlannerArena arena = onChart(name, chart);
    const Lattice &lattice = arena.chart->lattice();
    std::set<OffsetCoord> sea;
    while (sea.size() < static_cast<std::size_t>(columns * columns / 2))
        sea = flooded(*chart, lattice.cellAt(freePoint(random, *chart)));
    for (const char letter : {'A', 'B', 'C', 'D'})
        do
            arena.places[letter] = freePoint(random, *chart);
        while (sea.count(lattice.cellAt(arena.places[letter])) == 0 ||
               (letter == 'B' && (arena.places['B'] - arena.places['A']).norm() < 1.3 * static_cast<double>(columns)));
    forEachCell(chart->lattice(), 0,
                [&](typename LatticeType::Cell cell)
                {
                    if (sea.count(toOffset(cell)) == 0)
                        arena.places[chart->isFree(cell) ? 'E' : 'X'] = chart->lattice().centre(cell);
                });
    return arena;
}

/// A wall with a gap, and a ring that nothing gets into.
PlannerArena discs()
{
    PlannerArena arena;
    arena.name = "discs";
    arena.bounds = {Point(0, 0), Point(20, 14)};
    const auto put = [&](const Point &centre, double radius)
    {
        arena.discs.centres.push_back(centre);
        arena.discs.radii.push_back(radius);
    };
    for (int k = 0; k < 10; ++k)
        put(Point(13, 7) + 2.0 * Point(std::cos(0.2 * M_PI * k), std::sin(0.2 * M_PI * k)), 0.9);
    for (int k = 0; k < 6; ++k)
        put(Point(6, 1.6 * k), 1.1);
    arena.places = {{'A', {1.7, 2}}, {'B', {18, 12.3}}, {'C', {2, 12}}, {'D', {18, 2.2}},
                    {'E', {13, 7}},  {'X', {15, 7}},    {'O', {21, 7}}};
    return arena;
}

class DiscsChecker : public ob::StateValidityChecker
{
public:
    DiscsChecker(const ob::SpaceInformationPtr &si, Discs discs, QuestionHook onQuestion)
        : ob::StateValidityChecker(si), footing_(si->getStateSpace().get()), discs_(std::move(discs)),
          onQuestion_(std::move(onQuestion))
    {
        specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
    }

    bool isValid(const ob::State *state) const override
    {
        onQuestion_();
        return si_->satisfiesBounds(state) && clearance(state) > 0.0;
    }

    double clearance(const ob::State *state) const override
    {
        const Point p = footing_.position(state);
        double least = 100.0;
        for (std::size_t i = 0; i < discs_.centres.size(); ++i)
            least = std::min(least, (p - discs_.centres[i]).norm() - discs_.radii[i]);
        return least;
    }

private:
    Footing footing_;
    Discs discs_;
    QuestionHook onQuestion_;
};

template <class LatticeType>
bool isClearOf(const Occupancy &chart, const LatticeType &lattice, const Point &a, const Point &b)
{
    const CellOracle<LatticeType> oracle(lattice);
    const Point margin = Point::Constant(lattice.pitch());
    const Box around = {a.cwiseMin(b) - margin, a.cwiseMax(b) + margin};
    bool clear = true;
    forEachCell(lattice, 1,
                [&](typename LatticeType::Cell cell)
                {
                    if (clear && chart.isBlocked(toOffset(cell)) && around.contains(lattice.centre(cell)))
                        clear = oracle.distance(a, b, cell) > 0.0L;
                });
    return clear;
}

std::vector<PlannerArena> everyArena()
{
    struct Kind
    {
        std::string name;
        bool needsHexagons;
        std::function<ob::StateSpacePtr(const PlannerArena &, const CensusPtr &)> makeSpace;
    };
    const std::vector<Kind> kinds = {
        {"R2", false,
         [](const auto &arena, const auto &census)
         {
             return countingPlane(arena.bounds, census);
         }},
        {"SE2", false,
         [](const auto &arena, const auto &census)
         {
             return countingPoses(arena.bounds, census);
         }},
        {"Cells", true,
         [](const auto &arena, const auto &census)
         {
             return countingCells(*arena.chart->lattice().hexagons(), census);
         }},
    };
    std::vector<PlannerArena> arenas;
    for (const PlannerArena &arena : {bay(), strait(), openWater(), archipelago<HexLattice>("archipelago", 20),
                                      archipelago<HexLattice>("ocean", 36), squareBay(), squareStrait(),
                                      archipelago<SquareLattice>("square archipelago", 20), discs()})
        for (const Kind &kind : kinds)
            if (!kind.needsHexagons || (arena.chart && arena.chart->lattice().hexagons() != nullptr))
            {
                arenas.push_back(arena);
                arenas.back().name += " in " + kind.name;
                arenas.back().makeSpace = kind.makeSpace;
            }
    arenas.push_back(discs());
    arenas.back().name = "columns in R3";
    arenas.back().makeSpace = [](const auto &arena, const auto &census)
    {
        return countingSolid(arena.bounds, census);
    };
    return arenas;
}

}  // namespace

bool PlannerArena::isClear(const Point &a, const Point &b) const
{
    if (!bounds.contains(a) || !bounds.contains(b))
        return false;
    if (!chart)
    {
        Discs smaller = discs;
        for (double &radius : smaller.radii)
            radius *= 0.97;
        return smaller.isFree(a, b);
    }
    const Lattice &lattice = chart->lattice();
    return lattice.hexagons() != nullptr ? isClearOf(*chart, *lattice.hexagons(), a, b)
                                         : isClearOf(*chart, *lattice.squares(), a, b);
}

bool PlannerArena::areJoined(const Point &a, const Point &b) const
{
    return flooded(*chart, chart->lattice().cellAt(a)).count(chart->lattice().cellAt(b)) > 0;
}

Point PlannerArena::somewhere(Random &random) const
{
    if (chart)
        return freePoint(random, *chart);
    for (;;)
    {
        Point p = random.pointIn(bounds);
        if (discs.isFree(p))
            return p;
    }
}

const std::vector<PlannerArena> &plannerArenas()
{
    static const std::vector<PlannerArena> arenas = everyArena();
    return arenas;
}

ob::SpaceInformationPtr spaceInformation(const PlannerArena &arena, const CensusPtr &census,
                                         const QuestionHook &onQuestion)
{
    auto si = std::make_shared<ob::SpaceInformation>(arena.makeSpace(arena, census));
    if (arena.chart)
    {
        si->setStateValidityChecker(std::make_shared<OccupancyValidityChecker>(si, arena.chart));
        si->setMotionValidator(std::make_shared<OccupancyMotionValidator>(si, arena.chart));
    }
    else
    {
        si->setStateValidityChecker(std::make_shared<DiscsChecker>(si, arena.discs, onQuestion));
        si->setStateValidityCheckingResolution(0.01);
    }
    si->setup();
    return si;
}

}  // namespace seahex::test
