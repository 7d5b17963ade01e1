// HexAStar and SquareAStar on charts of their own cells find the optimum of the lattice, whatever the neighbours, the
// rule of jumps, the objective and the guidance; read and asked alike.

#include "planning/ChartQuestion.h"

#include <cmath>
#include <map>
#include <string>

namespace seahex::test
{
namespace
{

template <class Kind>
class LatticeOptima : public ::testing::Test
{
};

TYPED_TEST_SUITE(LatticeOptima, PlannerKinds, PlannerNames);

TYPED_TEST(LatticeOptima, AreDijkstrasReadAndAsked)
{
    std::map<std::string, int> found;
    int unreachable = 0;
    forEachSeed(800,
                [&](Random &random)
                {
                    const ChartObjective &objective = chartObjectives[static_cast<std::size_t>(random.integer(0, 7))];
                    const ChartQuestion<TypeParam> question(random, objective);
                    SCOPED_TRACE(objective.name + ", " + toString(question.guidance) + ", reach " +
                                 std::to_string(question.reach) + toPicture(*question.world.occupancy));
                    for (const JumpRule rule : {JumpRule::Safe, JumpRule::Hopping})
                    {
                        SCOPED_TRACE(toString(rule));
                        const double least = question.leastCost(rule);
                        (std::isinf(least) ? unreachable : found[objective.name]) += 1;
                        std::vector<Point> paths[2];
                        for (const bool isDirect : {true, false})
                        {
                            SCOPED_TRACE(isDirect ? "read" : "asked");
                            const auto planner = question.planner(rule, isDirect);
                            question.solve(*planner, least, rule);
                            paths[isDirect] = question.positions();
                        }
                        ASSERT_EQ(paths[true], paths[false]);
                    }
                });
    for (const ChartObjective &objective : chartObjectives)
        EXPECT_GT(found[objective.name], 60) << objective.name;
    EXPECT_GT(unreachable, 60);
}

TYPED_TEST(LatticeOptima, AreSafeOnesAgainAfterHops)
{
    int cheaper = 0;
    forEachSeed(150,
                [&](Random &random)
                {
                    const ChartObjective &objective = chartObjectives[static_cast<std::size_t>(random.integer(0, 2))];
                    const ChartQuestion<TypeParam> question(random, objective);
                    SCOPED_TRACE(objective.name + toPicture(*question.world.occupancy));
                    const double safe = question.leastCost(JumpRule::Safe);
                    const double hopping = question.leastCost(JumpRule::Hopping);
                    ASSERT_LE(hopping, safe + 1e-9);
                    cheaper += hopping < safe - 1e-9 ? 1 : 0;
                    const auto planner = question.planner(JumpRule::Hopping, random.chance(0.5));
                    question.solve(*planner, hopping, JumpRule::Hopping);
                    planner->setJumps(JumpRule::Safe);
                    question.solve(*planner, safe, JumpRule::Safe);
                    planner->setJumps("hopping");
                    question.solve(*planner, hopping, JumpRule::Hopping);
                });
    EXPECT_GT(cheaper, 12);
}

}  // namespace
}  // namespace seahex::test
