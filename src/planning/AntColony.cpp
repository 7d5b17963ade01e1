#include "seahex/planning/AntColony.h"

namespace seahex
{

AntColony::AntColony(const ompl::base::SpaceInformationPtr &si) : SlicePlanner(si, "AntColony")
{
    declareParam<unsigned int>("ants", this, &AntColony::setAnts, &AntColony::getAnts, "1:1:10000");
    declareParam<unsigned int>("iterations", this, &AntColony::setIterations, &AntColony::getIterations, "1:1:1000000");
    declareParam<double>("evaporation", this, &AntColony::setEvaporation, &AntColony::getEvaporation, "0.:.05:1.");
    declareParam<double>("elite", this, &AntColony::setElite, &AntColony::getElite, "0.:1.:1000.");
    declareParam<double>("alpha", this, &AntColony::setAlpha, &AntColony::getAlpha, "0.:.5:20.");
    declareParam<double>("beta", this, &AntColony::setBeta, &AntColony::getBeta, "0.:.5:20.");
    declareParam<unsigned int>("reach", this, &AntColony::setReach, &AntColony::getReach, "1:1:1000");
    declareParam<unsigned int>("seed", this, &AntColony::setSeed, &AntColony::getSeed, "0:1:4294967295");
}

void AntColony::setAnts(unsigned int ants)
{
    requireRange("ants", ants, 1.0, 1e4);
    settings_.ants = static_cast<int>(ants);
    forgetSearch();
}

void AntColony::setIterations(unsigned int iterations)
{
    requireRange("iterations", iterations, 1.0, 1e6);
    settings_.iterations = static_cast<int>(iterations);
    forgetSearch();
}

void AntColony::setEvaporation(double share)
{
    requireRange("evaporation", share, 0.0, 1.0);
    settings_.evaporation = share;
    forgetSearch();
}

void AntColony::setElite(double elite)
{
    requireRange("elite", elite, 0.0, 1000.0);
    settings_.elite = elite;
    forgetSearch();
}

void AntColony::setAlpha(double alpha)
{
    requireRange("alpha", alpha, 0.0, 20.0);
    settings_.alpha = alpha;
    forgetSearch();
}

void AntColony::setBeta(double beta)
{
    requireRange("beta", beta, 0.0, 20.0);
    settings_.beta = beta;
    forgetSearch();
}

void AntColony::setReach(unsigned int steps)
{
    requireRange("reach", steps, 1.0, 1000.0);
    settings_.reach = static_cast<int>(steps);
    forgetSearch();
}

void AntColony::setSeed(unsigned int seed)
{
    settings_.seed = seed;
    forgetSearch();
}

std::unique_ptr<SliceSearch> AntColony::makeSearch(const SliceProblem &problem) const
{
    return std::make_unique<AntColonySearch>(problem, settings_);
}

}  // namespace seahex
