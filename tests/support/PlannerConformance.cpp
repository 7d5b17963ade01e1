#include "support/PlannerConformance.h"

#include "support/conformance/Themes.h"
#include "support/conformance/Trial.h"

#include <exception>
#include <regex>

namespace seahex::test
{
namespace
{

std::vector<PlannerCheck> everyCheck()
{
    std::vector<PlannerCheck> checks;
    for (const auto &theme :
         {lifecycleChecks(), statusChecks(), budgetChecks(), goalChecks(), resultChecks(), objectiveChecks(),
          improvementChecks(), progressChecks(), plannerDataChecks(), settingChecks(), companyChecks()})
        checks.insert(checks.end(), theme.begin(), theme.end());
    return checks;
}

}  // namespace

const std::vector<PlannerCheck> &plannerChecks()
{
    static const std::vector<PlannerCheck> checks = everyCheck();
    return checks;
}

std::vector<PlannerArena> arenasFor(const PlannerUnderTest &planner)
{
    std::vector<PlannerArena> arenas;
    for (const PlannerArena &arena : plannerArenas())
        if (std::regex_match(arena.name, std::regex(planner.arenas)))
            arenas.push_back(arena);
    return arenas;
}

Violations violationsOf(const PlannerCheck &check, const PlannerUnderTest &planner, const PlannerArena &arena)
{
    Trial trial(planner, arena);
    try
    {
        check.run(trial);
    }
    catch (const std::exception &exception)
    {
        trial.expect(false, std::string("an exception: ") + exception.what());
    }
    if (planner.freesEveryState)
        trial.expect(trial.statesAlive() == 0,
                     std::to_string(trial.statesAlive()) + " states are left when planner and problems are gone");
    Violations violations;
    for (const std::string &violation : trial.violations())
        violations.push_back(arena.name + ": " + violation);
    return violations;
}

}  // namespace seahex::test
