#pragma once

#include "support/PlannerConformance.h"

#include <vector>

namespace seahex::test
{

// The checks of plannerChecks(), a file a theme.

std::vector<PlannerCheck> lifecycleChecks();
std::vector<PlannerCheck> statusChecks();
std::vector<PlannerCheck> budgetChecks();
std::vector<PlannerCheck> goalChecks();
std::vector<PlannerCheck> resultChecks();
std::vector<PlannerCheck> objectiveChecks();
std::vector<PlannerCheck> improvementChecks();
std::vector<PlannerCheck> progressChecks();
std::vector<PlannerCheck> plannerDataChecks();
std::vector<PlannerCheck> settingChecks();
std::vector<PlannerCheck> companyChecks();

}  // namespace seahex::test
