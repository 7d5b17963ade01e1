#pragma once

#include <seahex/geometry/Point.h>

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

namespace seahex::test
{

/// Dijkstra's algorithm on a square grid, written for nothing but OMPL's contract: the planner that a suite of checks
/// has to find no fault with, and that defects are put into to see them found.
///
/// Of the library it uses PlanarEmbedding and nothing else, and it is for R^2 and SE(2). Grid points join their eight
/// neighbours, starts and goals every grid point as near as that.
class TextbookPlanner : public ompl::base::Planner
{
public:
    /// @throws ompl::Exception if states have no x and y
    explicit TextbookPlanner(const ompl::base::SpaceInformationPtr &si);
    ~TextbookPlanner() override;

    void setup() override;
    void clear() override;
    void setProblemDefinition(const ompl::base::ProblemDefinitionPtr &pdef) override;
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override;
    using ompl::base::Planner::solve;
    void getPlannerData(ompl::base::PlannerData &data) const override;

    /// Grid points along the longer side. @throws ompl::Exception unless there are 10 to 1000
    void setPoints(int points);
    int getPoints() const { return points_; }

private:
    enum class Kind
    {
        Start,
        Goal,
        Grid
    };

    struct Node
    {
        ompl::base::State *state;
        Kind kind;
        double cost;
        std::size_t parent;
        bool isReached;
        bool isExpanded;
    };

    using Entry = std::pair<double, std::size_t>;

    bool collectStates(const ompl::base::PlannerTerminationCondition &ptc);
    void addNode(const ompl::base::State *state, Kind kind);
    void layGrid();
    void beginAgain();
    void relax(std::size_t from, std::size_t to);
    void expand(std::size_t node);
    bool search(const ompl::base::PlannerTerminationCondition &ptc);
    void report(std::size_t goal);
    std::size_t countOf(Kind kind) const;

    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    int points_ = 40;
    Point low_;
    Point high_;
    double spacing_ = 0.0;
    ompl::base::OptimizationObjectivePtr problemObjective_;
    ompl::base::OptimizationObjectivePtr objective_;
    std::vector<Node> nodes_;
    std::vector<std::size_t> grid_;  // node of each point, row by row
    std::size_t columns_ = 0;
    std::priority_queue<Entry, std::vector<Entry>, std::function<bool(const Entry &, const Entry &)>> open_;
    std::shared_ptr<ompl::geometric::PathGeometric> solution_;
    std::atomic<double> bestCost_{std::numeric_limits<double>::infinity()};
    std::atomic<int> expanded_{0};
};

}  // namespace seahex::test
