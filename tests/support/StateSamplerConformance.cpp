#include "support/SpaceTrial.h"

#include <cmath>
#include <map>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

/// Draws a state `count` times, all of which must be within the bounds.
void forEachSample(SpaceTrial &trial, const std::string &rule, int count, const std::function<void(ob::State *)> &draw,
                   const std::function<void(const ob::State *)> &visit)
{
    const HeldState sample(trial.space);
    for (int i = 0; i < count; ++i)
    {
        draw(sample.get());
        if (!trial.space->satisfiesBounds(sample.get()))
            trial.report.broken(rule, "out of bounds: " + trial.text(sample.get()));
        visit(sample.get());
    }
}

/// Draws many times from what should be a uniform distribution over `states`; Pearson's chi-square tells if it is, and
/// wrongly so about once in 10^9 times.
void expectUniform(SpaceTrial &trial, const std::string &rule, const std::vector<Reals> &states,
                   const std::function<void(ob::State *)> &draw)
{
    constexpr int drawsEach = 40;
    std::map<Reals, int> seen;
    for (const Reals &state : states)
        seen[HeldState(trial.space, state).reals()] = 0;
    const int draws = drawsEach * static_cast<int>(seen.size());
    forEachSample(trial, rule, draws, draw,
                  [&](const ob::State *sample)
                  {
                      const auto found = seen.find(HeldState(trial.space, sample).reals());
                      if (found != seen.end())
                          ++found->second;
                      else
                          trial.report.broken(rule, "must not be drawn: " + trial.text(sample));
                  });
    double chiSquare = 0.0;
    for (const auto &[state, count] : seen)
        chiSquare += (count - drawsEach) * (count - drawsEach) / static_cast<double>(drawsEach);
    const auto freedom = static_cast<double>(seen.size() - 1);
    if (chiSquare > freedom + 7.0 * std::sqrt(2.0 * freedom) + 25.0)
        trial.report.broken(rule, "not uniform over " + std::to_string(seen.size()) +
                                      " states: chi-square = " + std::to_string(chiSquare));
}

void checkUniform(SpaceTrial &trial, ob::StateSampler &sampler)
{
    const std::string rule = "uniform sampler";
    const auto draw = [&sampler](ob::State *state)
    {
        sampler.sampleUniform(state);
    };
    if (!trial.promises.everyState.empty())
        return expectUniform(trial, rule, trial.promises.everyState, draw);
    std::vector<double> nearest(trial.pool.size(), trial.promises.extent);
    forEachSample(trial, rule, 2000, draw,
                  [&](const ob::State *sample)
                  {
                      for (std::size_t i = 0; i < nearest.size(); ++i)
                          nearest[i] = std::min(nearest[i], trial.space->distance(trial.pool[i].get(), sample));
                  });
    for (std::size_t i = 0; i < nearest.size(); ++i)
        if (nearest[i] > 0.2 * trial.promises.extent)
            trial.report.broken(rule, "never comes near " + trial.text(trial.pool[i].get()));
}

void checkNear(SpaceTrial &trial, ob::StateSampler &sampler)
{
    const std::string rule = "near sampler";
    for (std::size_t i = 0; i < 8; ++i)
    {
        const HeldState &centre = trial.any(trial.pool);
        for (const double share : {0.0, 0.003, 0.05, 0.3, 1.0, 50.0})
        {
            const double radius = share * trial.promises.extent;
            const double reach = trial.promises.nearReach * radius + trial.promises.rounding;
            forEachSample(
                trial, rule, 100, [&](ob::State *state) { sampler.sampleUniformNear(state, centre.get(), radius); },
                [&](const ob::State *sample)
                {
                    if (trial.space->distance(centre.get(), sample) > reach)
                        trial.report.broken(rule, trial.text(sample) + " is not within " + std::to_string(reach) +
                                                      " of " + trial.text(centre.get()));
                });
        }
        if (trial.promises.everyState.empty())
            continue;
        const HeldState &rim = trial.any(trial.pool);
        const double radius = trial.promises.distance(centre.reals(), rim.reals()) + 10.0 * trial.promises.rounding;
        std::vector<Reals> within;
        for (const Reals &state : trial.promises.everyState)
            if (trial.promises.distance(state, centre.reals()) <= radius)
                within.push_back(state);
        expectUniform(trial, rule, within,
                      [&](ob::State *state) { sampler.sampleUniformNear(state, centre.get(), radius); });
    }
}

void checkSpread(SpaceTrial &trial, ob::StateSampler &sampler)
{
    const auto &[mean, deviation] = *trial.promises.gaussian;
    const HeldState middle(trial.space, mean);
    constexpr int draws = 4000;
    Reals sums(mean.size(), 0.0);
    Reals squares(mean.size(), 0.0);
    forEachSample(
        trial, "gaussian sampler", draws,
        [&, sigma = deviation](ob::State *state) { sampler.sampleGaussian(state, middle.get(), sigma); },
        [&](const ob::State *sample)
        {
            const Reals drawn = HeldState(trial.space, sample).reals();
            for (std::size_t axis = 0; axis < sums.size(); ++axis)
            {
                const double off = drawn[axis] - middle.reals()[axis];
                sums[axis] += off;
                squares[axis] += off * off;
            }
        });
    for (std::size_t axis = 0; axis < sums.size(); ++axis)
    {
        if (std::abs(sums[axis]) / draws > 7.0 * deviation / std::sqrt(draws))
            trial.report.broken("gaussian sampler", "mean off by " + std::to_string(sums[axis] / draws));
        const double found = std::sqrt(squares[axis] / draws);
        if (std::abs(found - deviation) > 0.1 * deviation)
            trial.report.broken("gaussian sampler",
                                "a deviation of " + std::to_string(deviation) + " became " + std::to_string(found));
    }
}

void checkGaussian(SpaceTrial &trial, ob::StateSampler &sampler)
{
    for (const HeldState &mean : trial.pool)
        for (const double share : {0.0, 0.003, 0.1, 1.0, 50.0})
            forEachSample(
                trial, "gaussian sampler", 20,
                [&](ob::State *state) { sampler.sampleGaussian(state, mean.get(), share * trial.promises.extent); },
                [&](const ob::State *sample)
                {
                    if (share == 0.0 && !trial.same(sample, mean.get()))
                        trial.report.broken("gaussian sampler", "no deviation, and yet another state");
                });
    if (trial.promises.gaussian)
        checkSpread(trial, sampler);
}

}  // namespace

void checkSamplers(SpaceTrial &trial)
{
    const ob::StateSamplerPtr sampler = trial.space->allocDefaultStateSampler();
    checkUniform(trial, *sampler);
    checkNear(trial, *sampler);
    checkGaussian(trial, *sampler);
}

}  // namespace seahex::test
