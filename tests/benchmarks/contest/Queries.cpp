#include "contest/Queries.h"

#include <seahex/search/HexJumps.h>

#include <random>
#include <stdexcept>

namespace seahex::contest
{
namespace
{

constexpr int patience = 1'000'000;  // draws

/// One bit for every cell that hangs together with one of them.
class Water
{
public:
    Water(const HexOccupancy &occupancy, CellIndex first) : reached_(occupancy.layout().wordCount(), 0)
    {
        const HexJumps steps(occupancy.layout(), 1, JumpSet::Primitive);
        std::vector<CellIndex> open = {first};
        mark(first);
        while (!open.empty())
        {
            const CellIndex cell = open.back();
            open.pop_back();
            for (const Jump &step : steps.from(steps.parity(cell)))
            {
                const auto next = static_cast<CellIndex>(static_cast<std::int64_t>(cell) + step.delta);
                if (occupancy.isBlockedAt(next) || contains(next))
                    continue;
                mark(next);
                open.push_back(next);
            }
        }
    }

    bool contains(CellIndex cell) const { return (reached_[cell >> 6] >> (cell & 63)) & 1; }
    std::int64_t cellCount() const { return cellCount_; }

private:
    void mark(CellIndex cell)
    {
        reached_[cell >> 6] |= std::uint64_t{1} << (cell & 63);
        ++cellCount_;
    }

    std::vector<std::uint64_t> reached_;
    std::int64_t cellCount_ = 0;
};

class Draw
{
public:
    Draw(const HexLattice &lattice, std::uint64_t seed) : lattice_(lattice), engine_(seed) {}

    HexCoord cell() { return toCube({below(lattice_.columns()), below(lattice_.rows())}); }

private:
    std::int64_t below(std::int64_t end)
    {
        return static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(end));
    }

    const HexLattice &lattice_;
    std::mt19937_64 engine_;
};

Water largeWater(const HexOccupancy &occupancy, Draw &draw)
{
    const std::int64_t freeCells = occupancy.lattice().cellCount() - occupancy.blockedCount();
    for (int i = 0; i < patience; ++i)
    {
        const HexCoord cell = draw.cell();
        if (occupancy.isBlocked(cell))
            continue;
        Water water(occupancy, occupancy.layout().index(cell));
        if (4 * water.cellCount() >= freeCells)
            return water;
    }
    throw std::runtime_error("no water holds a quarter of the free cells");
}

}  // namespace

std::vector<Query> drawQueries(const HexOccupancy &occupancy, std::size_t count, std::uint64_t seed)
{
    const HexLattice &lattice = occupancy.lattice();
    const CellLayout &layout = occupancy.layout();
    Draw draw(lattice, seed);
    const Water water = largeWater(occupancy, draw);
    const Box box = lattice.bounds();
    const double leastDistance = 0.4 * (box.max - box.min).norm();
    std::vector<Query> queries;
    for (int i = 0; i < patience && queries.size() < count; ++i)
    {
        const HexCoord start = draw.cell();
        const HexCoord goal = draw.cell();
        if (water.contains(layout.index(start)) && water.contains(layout.index(goal)) &&
            (lattice.centre(goal) - lattice.centre(start)).norm() >= leastDistance)
            queries.push_back({start, goal});
    }
    if (queries.size() < count)
        throw std::runtime_error("the world is too small, or too narrow, for so many long queries");
    return queries;
}

}  // namespace seahex::contest
