#include "planning/PrismQuery.h"

#include "seahex/search/PrismWater.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace seahex
{

PrismQuery::PrismQuery(const PrismGround &ground, const PrismLattice &lattice, int rings, std::vector<Point3> starts,
                       std::vector<Point3> goals)
    : ground_(ground), lattice_(lattice), layout_(lattice.plane().columns(), lattice.plane().rows()),
      moves_(lattice_, layout_, rings, ground.climb), starts_(std::move(starts)), goals_(std::move(goals))
{
    if (ground.arena)
        read_ = std::make_unique<PrismWater>(ground.arena, lattice_, layout_, moves_,
                                             Box{horizontal(ground.bounds.min()), horizontal(ground.bounds.max())});
    else
        asked_ = std::make_unique<SpacePrisms>(lattice_, layout_);
}

/// Motions between the ends and the nodes around: of the layers no farther than from one to the next, and as far away
/// as the vehicle may have to go to reach them.
std::vector<PrismQuery::Joint> PrismQuery::jointsOf(const std::vector<Point3> &ends, bool isStart,
                                                    PrismQuestions &questions) const
{
    const double run = ground_.climb == 0.0 ? 0.0 : lattice_.thickness() / ground_.climb / lattice_.pitch();
    const int rings = static_cast<int>(std::min(3.0, std::max(1.0, std::ceil(run))));
    std::vector<HexCoord> offsets = {HexCoord{}};
    for (const RingOffset &ring : ringOffsets(rings))
        offsets.push_back(ring.offset);
    constexpr double reach = 1.0 + 1e-9;
    std::vector<Joint> joints;
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
        const Point3 &end = ends[i];
        const HexCoord own = lattice_.plane().cellAt(horizontal(end));
        const double height = (end.z() - lattice_.top()) / lattice_.thickness();  // in layers
        const int first = std::max(0, static_cast<int>(std::ceil(height - reach)));
        const int last = std::min(lattice_.layers() - 1, static_cast<int>(std::floor(height + reach)));
        for (int layer = first; layer <= last; ++layer)
            for (const HexCoord offset : offsets)
            {
                const HexCoord cell = own + offset;
                const Point3 node = lattice_.node(cell, layer);
                if (!lattice_.plane().contains(cell) || !ground_.bounds.contains(node))
                    continue;
                if (isStart ? questions.isValid(end, node) : questions.isValid(node, end))
                    joints.push_back(
                        {graph_->state(layout_.index(cell), layer), (node - end).norm() / lattice_.pitch(), i});
            }
    }
    return joints;
}

bool PrismQuery::join(SpaceJudge &judge)
{
    PrismMotions &motions = read_ ? *read_ : *asked_;
    graph_ = std::make_unique<PrismGraph>(lattice_, layout_, moves_, motions, std::vector<PrismGoal>());
    PrismQuestions questions(ground_, judge, answers_);
    startJoints_ = jointsOf(starts_, true, questions);
    goalJoints_ = jointsOf(goals_, false, questions);
    if (questions.isOver())
        return false;
    std::vector<PrismGoal> goals;
    for (const Point3 &goal : goals_)
        goals.push_back({goal, {}});
    for (const Joint &joint : goalJoints_)
        goals[joint.end].joints.emplace_back(joint.state, joint.length);
    graph_ = std::make_unique<PrismGraph>(lattice_, layout_, moves_, motions, goals);
    search_ = std::make_unique<AStar<PrismGraph>>(*graph_);
    if (!goalJoints_.empty())
        for (const Joint &joint : startJoints_)
            search_->addStart(joint.state, joint.length);
    return true;
}

PrismQuery::Step PrismQuery::work(SpaceJudge &judge)
{
    if (!search_ && !join(judge))
        return Step::Interrupted;
    if (asked_)
        asked_->ask(judge);
    switch (search_->run([&judge] { return judge.isOver(); }, 25))
    {
        case SearchStatus::Found:
            return Step::Found;
        case SearchStatus::Exhausted:
            return Step::Exhausted;
        case SearchStatus::Stopped:
            break;
    }
    return Step::Interrupted;
}

const Point3 &PrismQuery::endOf(CellIndex state, const std::vector<Joint> &joints,
                                const std::vector<Point3> &ends) const
{
    const Joint *best = nullptr;
    for (const Joint &joint : joints)
        if (joint.state == state && (best == nullptr || joint.length < best->length))
            best = &joint;
    return ends[best->end];
}

std::vector<Point3> PrismQuery::path() const
{
    const std::vector<CellIndex> states = search_->path();
    std::vector<Point3> points = {endOf(states.front(), startJoints_, starts_)};
    for (const CellIndex state : states)
        points.push_back(graph_->position(state));
    points.push_back(endOf(states.back(), goalJoints_, goals_));
    // An end that is a node is joined to it by no way at all.
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

}  // namespace seahex
