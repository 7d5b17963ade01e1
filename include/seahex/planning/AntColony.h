#pragma once

#include <seahex/planning/SlicePlanner.h>
#include <seahex/slices/AntColonySearch.h>

namespace seahex
{

/// Ant colony on the slices of [Xu], for problems in R^3: the baseline that the layered planning is compared with
/// (AntColonySearch: the rules, where they come from, and what the settings mean). Slices, validity, answers and status
/// are those of SlicePlanner; each path with a lower F is an answer that may better the one before.
///
/// The same seed gives the same path. Where all iterations are over with no path, outcome() is Exhausted and
/// deadEnds() tells how far ants got, which proves nothing.
class AntColony : public SlicePlanner
{
public:
    /// @throws ompl::Exception if the space is not R^3
    explicit AntColony(const ompl::base::SpaceInformationPtr &si);

    // Setters throw ompl::Exception for values out of range.

    /// 1 to 10000, 20 by default.
    void setAnts(unsigned int ants);
    unsigned int getAnts() const { return static_cast<unsigned int>(settings_.ants); }

    /// 1 to 1000000, 100 by default.
    void setIterations(unsigned int iterations);
    unsigned int getIterations() const { return static_cast<unsigned int>(settings_.iterations); }

    /// 0 to 1, 0.1 by default.
    void setEvaporation(double share);
    double getEvaporation() const { return settings_.evaporation; }

    /// 0 to 1000, 5 by default.
    void setElite(double elite);
    double getElite() const { return settings_.elite; }

    /// 0 to 20, 1 by default.
    void setAlpha(double alpha);
    double getAlpha() const { return settings_.alpha; }

    /// 0 to 20, 5 by default.
    void setBeta(double beta);
    double getBeta() const { return settings_.beta; }

    /// 1 to 1000, 2 by default.
    void setReach(unsigned int steps);
    unsigned int getReach() const { return static_cast<unsigned int>(settings_.reach); }

    void setSeed(unsigned int seed);
    unsigned int getSeed() const { return settings_.seed; }

private:
    std::unique_ptr<SliceSearch> makeSearch(const SliceProblem &problem) const override;

    AntSettings settings_;
};

}  // namespace seahex
