#include "contest/TextbookAStar.h"

#include <seahex/geometry/HexNorm.h>
#include <seahex/geometry/HexRing.h>
#include <seahex/geometry/HexTraversal.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>

namespace seahex::contest
{
namespace
{

struct CellHash
{
    std::size_t operator()(HexCoord cell) const
    {
        // as std::hash has it for one number: neighbours of a row lie in buckets side by side
        return static_cast<std::size_t>(cell.q + (cell.s << 20));
    }
};

struct Entry
{
    double estimate;
    double cost;
    HexCoord cell;
};

struct Later
{
    bool operator()(const Entry &a, const Entry &b) const
    {
        return a.estimate != b.estimate ? a.estimate > b.estimate : a.cost < b.cost;
    }
};

}  // namespace

TextbookAStar::TextbookAStar(const HexOccupancy &occupancy, int rings, bool guided)
    : occupancy_(occupancy), rings_(rings), guided_(guided)
{
    for (const RingOffset &ring : ringOffsets(rings))
    {
        if (!ring.primitive)
            continue;
        const auto q = static_cast<double>(ring.offset.q);
        const auto s = static_cast<double>(ring.offset.s);
        Neighbour neighbour{ring.offset, std::sqrt(q * q + q * s + s * s), {}};
        forEachTouchedCell(HexCoord{}, ring.offset,
                           [&](HexCoord cell)
                           {
                               if (cell != HexCoord{})
                                   neighbour.touched.push_back(cell);
                               return true;
                           });
        neighbours_.push_back(std::move(neighbour));
    }
}

bool TextbookAStar::isValid(HexCoord cell, const Neighbour &neighbour) const
{
    return std::all_of(neighbour.touched.begin(), neighbour.touched.end(),
                       [&](HexCoord touched) { return occupancy_.isFree(cell + touched); });
}

double TextbookAStar::remaining(HexCoord cell, HexCoord goal) const
{
    if (!guided_)
        return 0.0;
    return rings_ == 1 ? static_cast<double>(hexDistance(cell, goal)) : ringNorm(goal - cell, rings_);
}

Answer TextbookAStar::solve(const Query &query)
{
    Answer answer;
    std::priority_queue<Entry, std::vector<Entry>, Later> open;
    std::unordered_map<HexCoord, double, CellHash> cost;
    std::unordered_map<HexCoord, HexCoord, CellHash> parent;
    open.push({remaining(query.start, query.goal), 0.0, query.start});
    cost[query.start] = 0.0;
    while (!open.empty())
    {
        const Entry entry = open.top();
        open.pop();
        if (entry.cost > cost[entry.cell])
            continue;
        ++answer.expanded;
        if (entry.cell == query.goal)
        {
            answer.cost = entry.cost;
            break;
        }
        for (const Neighbour &neighbour : neighbours_)
        {
            if (!isValid(entry.cell, neighbour))
                continue;
            const HexCoord next = entry.cell + neighbour.offset;
            const double nextCost = entry.cost + neighbour.length;
            const auto known = cost.find(next);
            // sums of the same jumps in another order differ in the last digits
            if (known != cost.end() && nextCost >= known->second - 1e-9)
                continue;
            cost[next] = nextCost;
            parent[next] = entry.cell;
            open.push({nextCost + remaining(next, query.goal), nextCost, next});
        }
    }
    std::vector<HexCoord> path;
    if (std::isfinite(answer.cost))
        for (HexCoord cell = query.goal; cell != query.start; cell = parent[cell])
            path.push_back(cell);

    answer.touched = cost.size();
    // a node holds the pair, the next one's address and the hash; the maps' buckets are addresses
    answer.memory.touched = cost.size() * (sizeof(HexCoord) + sizeof(double) + 2 * sizeof(void *)) +
                            parent.size() * (2 * sizeof(HexCoord) + 2 * sizeof(void *)) +
                            (cost.bucket_count() + parent.bucket_count()) * sizeof(void *) +
                            open.size() * sizeof(Entry);
    return answer;
}

}  // namespace seahex::contest
