#include "seahex/search/JumpPointSearch.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <utility>

namespace seahex
{
namespace
{

struct Step
{
    std::int32_t q;
    std::int32_t s;
};

/// A lead beside a ray, and the step to the neighbour behind on that side, which must be blocked for a turn.
struct Beside
{
    unsigned int lead;
    Step behind;
};

constexpr Step east{1, 0};
constexpr Step northEast{1, -1};
constexpr Step northWest{0, -1};
constexpr Step west{-1, 0};
constexpr Step southWest{-1, 1};
constexpr Step southEast{0, 1};

constexpr std::array<Step, 3> raySteps = {east, northWest, southWest};
constexpr std::array<Step, 3> leadSteps = {northEast, west, southEast};

// first the one to the right, then the one to the left
constexpr std::array<std::array<unsigned int, 2>, 3> raysBesideLead = {{{0, 1}, {1, 2}, {2, 0}}};
// first the one to whose side acrossRay() is negative
constexpr std::array<std::array<Beside, 2>, 3> leadsBesideRay = {{
    {{{0, northWest}, {2, southWest}}},
    {{{1, southWest}, {0, east}}},
    {{{2, east}, {1, northWest}}},
}};

constexpr bool areThoseOfHexRays()
{
    for (std::size_t ray = 0; ray < raySteps.size(); ++ray)
        if (raySteps[ray].q != HexRays::steps[ray].q || raySteps[ray].s != HexRays::steps[ray].s)
            return false;
    return true;
}
static_assert(areThoseOfHexRays());

/// Before anything is made for it.
const CellLayout &fitting(const CellLayout &layout)
{
    constexpr std::int64_t most = std::int64_t{1} << 27;
    if (layout.columns() > most || layout.rows() > most)
        throw std::length_error("a jump point search takes at most 2^27 columns and rows");
    return layout;
}

/// How far a cell lies beside the line of a ray: to the side of its first lead if negative.
std::int32_t acrossRay(unsigned int ray, std::int32_t q, std::int32_t s)
{
    return ray == 0 ? s : ray == 1 ? q : -q - s;
}

/// How many steps of a lead bring a cell so far away nearer by one each.
std::uint32_t stepsNearing(unsigned int lead, std::int32_t q, std::int32_t s)
{
    // what lies between the lead and a ray 60 degrees off it is a sum of both; how often the lead
    const std::int32_t r = -q - s;
    const std::int32_t steps = lead == 0 ? std::min(q, -s) : lead == 1 ? std::min(r, -q) : std::min(s, -r);
    return static_cast<std::uint32_t>(std::max(steps, 0));
}

}  // namespace

JumpPointSearch::JumpPointSearch(const Occupancy &occupancy, std::shared_ptr<const HexRays> rays)
    : layout_(fitting(occupancy.layout())), blocked_(occupancy.words().data()),
      rays_(rays ? std::move(rays) : std::make_shared<const HexRays>(occupancy)), store_(layout_.size()), leadDeltas_(),
      goalAddress_()
{
    for (std::size_t lead = 0; lead < leadSteps.size(); ++lead)
        for (std::size_t side = 0; side < 2; ++side)
            leadDeltas_[lead][side] = rays_->delta(raysBesideLead[lead][side], {leadSteps[lead].q, leadSteps[lead].s});
}

void JumpPointSearch::begin(HexCoord start, HexCoord goal)
{
    store_.clear();
    nodes_.clear();
    stacks_.clear();
    current_ = 0;
    openSize_ = 0;
    goalNode_.reset();
    scannedWords_ = 0;
    leadCells_ = 0;
    counters_ = {};
    goalQ_ = static_cast<std::int32_t>(goal.q);
    goalS_ = static_cast<std::int32_t>(goal.s);
    for (unsigned int ray = 0; ray < HexRays::directions; ++ray)
        goalAddress_[ray] = rays_->address(ray, goal);
    const auto q = static_cast<std::int32_t>(start.q);
    const auto s = static_cast<std::int32_t>(start.s);
    startBound_ = remaining(q, s);
    improves(indexOf(q, s), 0);
    push(startBound_, {q, s, 0, none, none, atStart});
}

SearchStatus JumpPointSearch::run(const std::function<bool()> &stop, std::uint64_t pollInterval)
{
    std::uint64_t untilPoll = 0;
    while (!goalNode_ && openSize_ != 0)
    {
        if (stacks_[current_] == none)
        {
            ++current_;
            continue;
        }
        if (untilPoll-- == 0)
        {
            if (stop && stop())
                return SearchStatus::Stopped;
            untilPoll = pollInterval - 1;
        }
        const std::uint32_t index = stacks_[current_];
        stacks_[current_] = nodes_[index].below;
        --openSize_;
        expand(index);
    }
    return goalNode_ ? SearchStatus::Found : SearchStatus::Exhausted;
}

/// Labels the cell if it has no label as low.
inline bool JumpPointSearch::improves(CellIndex cell, std::uint32_t cost)
{
    if (!store_.isReached(cell))
    {
        store_.markReached(cell);
        ++counters_.generated;
    }
    else if (store_.label(cell) <= cost)
        return false;
    else
        ++counters_.improved;
    store_.setLabel(cell, cost);
    return true;
}

inline void JumpPointSearch::push(std::uint32_t estimate, const Node &node)
{
    const std::size_t stack = estimate - startBound_;
    if (stack >= stacks_.size())
        stacks_.resize(stack + 1, none);
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(node);
    nodes_.back().below = stacks_[stack];
    stacks_[stack] = index;
    ++openSize_;
}

void JumpPointSearch::expand(std::uint32_t index)
{
    const Node node = nodes_[index];
    const CellIndex cell = indexOf(node.q, node.s);
    const bool isLead = node.kind >= firstLead && node.kind < atStart;
    if (!isLead && store_.label(cell) < node.cost)
        return;
    ++counters_.expanded;
    if (trace_ != nullptr)
        trace_->push_back(cell);
    if (node.q == goalQ_ && node.s == goalS_)
    {
        goalNode_ = index;
        return;
    }
    if (isLead)
    {
        followLead(node.kind - firstLead, node.q, node.s, node.cost, node.parent);
        return;
    }
    const auto sendRayHere = [&](unsigned int ray)
    {
        const HexRays::Address from = rays_->address(ray, {node.q, node.s});
        switch (ray)
        {
            case 0:
                return sendRay<0>(from, node.q, node.s, node.cost, index);
            case 1:
                return sendRay<1>(from, node.q, node.s, node.cost, index);
            default:
                return sendRay<2>(from, node.q, node.s, node.cost, index);
        }
    };
    const auto beginLead = [&](unsigned int lead)
    {
        followLead(lead, node.q + leadSteps[lead].q, node.s + leadSteps[lead].s, node.cost + 1, index);
    };
    if (node.kind == atStart)
    {
        for (unsigned int ray = 0; ray < HexRays::directions; ++ray)
            sendRayHere(ray);
        for (unsigned int lead = 0; lead < leadSteps.size(); ++lead)
            beginLead(lead);
        return;
    }
    sendRayHere(node.kind);
    for (const Beside &beside : leadsBesideRay[node.kind])
        if (isBlocked(node.q + beside.behind.q, node.s + beside.behind.s))
            beginLead(beside.lead);
}

inline void JumpPointSearch::followLead(unsigned int lead, std::int32_t q, std::int32_t s, std::uint32_t cost,
                                        std::uint32_t parent)
{
    switch (lead)
    {
        case 0:
            return followLead<0>(q, s, cost, parent);
        case 1:
            return followLead<1>(q, s, cost, parent);
        default:
            return followLead<2>(q, s, cost, parent);
    }
}

template <unsigned int lead>
void JumpPointSearch::followLead(std::int32_t q, std::int32_t s, std::uint32_t cost, std::uint32_t parent)
{
    constexpr unsigned int left = raysBesideLead[lead][1];
    constexpr unsigned int right = raysBesideLead[lead][0];
    constexpr Step step = leadSteps[lead];
    HexRays::Address atLeft = rays_->address(left, {q, s});
    if (rays_->isBlocked(left, atLeft))
        return;
    const std::uint32_t toGo = remaining(q, s);
    const std::uint32_t estimate = cost + toGo;
    if (estimate != startBound_ + current_)
    {
        push(estimate, {q, s, cost, parent, none, firstLead + lead});
        return;
    }
    HexRays::Address atRight = rays_->address(right, {q, s});
    const HexRays::Address stepLeft = leadDeltas_[lead][1];
    const HexRays::Address stepRight = leadDeltas_[lead][0];
    // as long as each step brings the goal nearer by one, the estimate stays what it is; the goal itself is pushed
    const std::uint32_t nearing = stepsNearing(lead, goalQ_ - q, goalS_ - s);
    for (const std::uint32_t end = cost + nearing + (nearing == toGo ? 0 : 1); cost != end; ++cost)
    {
        if (rays_->isBlocked(left, atLeft) || !improves(indexOf(q, s), cost))
            return;
        ++leadCells_;
        sendRay<left>(atLeft, q, s, cost, parent);
        sendRay<right>(atRight, q, s, cost, parent);
        atLeft += stepLeft;
        atRight += stepRight;
        q += step.q;
        s += step.s;
    }
    if (!rays_->isBlocked(left, atLeft))
        push(cost + remaining(q, s), {q, s, cost, parent, none, firstLead + lead});
}

template <unsigned int ray>
inline void JumpPointSearch::sendRay(HexRays::Address from, std::int32_t q, std::int32_t s, std::uint32_t cost,
                                     std::uint32_t parent)
{
    HexRays::Stop stop = rays_->firstStop(ray, from);
    scannedWords_ += stop.words;
    // lines end with blocked cells, so that what lies before the stop lies on this line
    const HexRays::Address toGoal = goalAddress_[ray] - from;
    if (toGoal > 0 && toGoal <= stop.distance)
        stop = {toGoal, true, 0};
    if (!stop.isTurn)
        return;
    const auto distance = static_cast<std::int32_t>(stop.distance);
    q += distance * raySteps[ray].q;
    s += distance * raySteps[ray].s;
    cost += static_cast<std::uint32_t>(distance);
    if (improves(indexOf(q, s), cost))
        push(cost + remaining(q, s), {q, s, cost, parent, none, ray});
}

double JumpPointSearch::cost() const
{
    return goalNode_ ? static_cast<double>(nodes_[*goalNode_].cost) : std::numeric_limits<double>::infinity();
}

std::vector<CellIndex> JumpPointSearch::path() const
{
    std::vector<CellIndex> cells;
    if (!goalNode_)
        return cells;
    const Node *node = &nodes_[*goalNode_];
    cells.reserve(node->cost + 1);
    cells.push_back(indexOf(node->q, node->s));
    for (; node->parent != none; node = &nodes_[node->parent])
    {
        const Node &parent = nodes_[node->parent];
        std::int32_t q = node->q;
        std::int32_t s = node->s;
        const auto goBack = [&](Step step, std::uint32_t count)
        {
            for (; count != 0; --count)
            {
                q -= step.q;
                s -= step.s;
                cells.push_back(indexOf(q, s));
            }
        };
        // the lead's steps come first, so that backwards they come last
        const std::uint32_t steps = node->cost - parent.cost;
        if (node->kind >= firstLead)
        {
            goBack(leadSteps[node->kind - firstLead], steps);
            continue;
        }
        const std::int32_t across = acrossRay(node->kind, node->q - parent.q, node->s - parent.s);
        const auto aside = static_cast<std::uint32_t>(std::abs(across));
        goBack(raySteps[node->kind], steps - aside);
        goBack(leadSteps[leadsBesideRay[node->kind][across > 0 ? 1 : 0].lead], aside);
    }
    std::reverse(cells.begin(), cells.end());
    return cells;
}

SearchMemory JumpPointSearch::memory() const
{
    return {2 * store_.size() / 8 + rays_->bytes(),
            (static_cast<std::size_t>(counters_.generated) + store_.touchedWords().capacity() + stacks_.capacity()) *
                    sizeof(std::uint32_t) +
                nodes_.capacity() * sizeof(Node)};
}

double JumpPointSearch::lowerBound() const
{
    if (goalNode_ || openSize_ == 0)
        return cost();
    std::size_t least = current_;
    while (stacks_[least] == none)
        ++least;
    return static_cast<double>(startBound_ + least);
}

}  // namespace seahex
