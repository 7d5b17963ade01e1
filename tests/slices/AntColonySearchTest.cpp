#include "slices/SliceWorlds.h"

#include <seahex/slices/AntColonySearch.h>
#include <seahex/slices/ExactSelection.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <random>

namespace seahex::test
{
namespace
{

AntSettings fewAnts(std::uint32_t seed)
{
    AntSettings settings;
    settings.ants = 5;
    settings.iterations = 6;
    settings.seed = seed;
    return settings;
}

TEST(AntColonySearch, PathsAreUsableAndNeverBetterThanTheBest)
{
    int found = 0;
    forEachSeed(60,
                [&](Random &random)
                {
                    const SliceStack stack = randomStack(random, randomFrame(random, {6, 6, 5}), random.real(0.0, 0.6));
                    const SliceProblem problem(stack, randomCriterion(random));
                    const auto legs = randomLegs(random, random.real(0.3, 1.0));
                    AntColonySearch ants(problem, fewAnts(3));
                    ExactSelection exact(problem);
                    RecordingJudge judge(legs);
                    RecordingJudge other(legs);
                    finish(exact, other);
                    double before = std::numeric_limits<double>::infinity();
                    while (ants.work(judge) == SliceSearch::Step::Better)
                    {
                        expectUsable(problem, *ants.best(), legs);
                        const double total = problem.figures(*ants.best()).total;
                        EXPECT_LT(total, before);
                        before = total;
                    }
                    EXPECT_EQ(ants.iterations(), 6);
                    EXPECT_LE(judge.mostRepeats(), 1);
                    EXPECT_LE(ants.farthestPlane(), exact.farthestPlane());
                    if (!ants.best())
                        return;
                    ++found;
                    ASSERT_TRUE(exact.best());
                    EXPECT_GE(before, problem.figures(*exact.best()).total - 1e-9);
                });
    EXPECT_GT(found, 20);
}

/// Ant System on slices as the header words it, with nothing remembered: the odds of every open point of a plane, each
/// leg asked for again, and the ants' own numbers.
std::optional<SlicePath> literalAnts(const SliceProblem &problem, const AntSettings &settings,
                                     const RecordingJudge::Rule &isValid)
{
    const SliceFrame &frame = problem.frame();
    std::mt19937_64 engine(settings.seed);
    std::map<std::pair<int, std::size_t>, double> trail;  // what differs from 1 at first
    std::optional<SlicePath> best;
    double least = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < settings.iterations; ++iteration)
    {
        std::vector<SlicePath> arrived;
        for (int ant = 0; ant < settings.ants; ++ant)
        {
            SlicePath path;
            Eigen::Vector3d at = frame.start();
            bool isLost = false;
            for (int plane = 1; plane + 1 < frame.planes() && !isLost; ++plane)
            {
                std::map<std::size_t, double> odds;
                for (std::size_t i = 0; i < frame.cellCount(); ++i)
                {
                    const Eigen::Vector3d next = frame.position(plane, frame.cell(i));
                    const Eigen::Vector2d steps = frame.gridCoordinates(next) - frame.gridCoordinates(at);
                    if (!problem.isOpen(plane, i) || steps.cwiseAbs().maxCoeff() > settings.reach + 1e-9)
                        continue;
                    const double safety =
                        1.0 - problem.stack().danger(plane, frame.cell(i), problem.criterion().neighbourhood);
                    const double far = (next - at).norm() + (frame.goal() - next).norm();
                    const double strength = trail.emplace(std::make_pair(plane, i), 1.0).first->second;
                    odds[i] =
                        std::pow(strength, settings.alpha) * std::pow(safety / far * frame.spacing(), settings.beta);
                }
                for (bool isThere = false; !isThere && !isLost;)
                {
                    isLost = odds.empty();
                    if (isLost)
                        break;
                    double sum = 0.0;
                    for (const auto &choice : odds)
                        sum += choice.second;
                    double drawn = static_cast<double>(engine() >> 11) / 9007199254740992.0 * sum;
                    auto choice = odds.begin();
                    while (std::next(choice) != odds.end() && drawn >= choice->second)
                        drawn -= (choice++)->second;
                    const Eigen::Vector3d next = frame.position(plane, frame.cell(choice->first));
                    isThere = isValid(at, next);
                    if (isThere)
                    {
                        path.push_back(frame.cell(choice->first));
                        at = next;
                    }
                    else
                        odds.erase(choice);
                }
            }
            if (!isLost)
                engine();  // the goal is the only choice
            if (isLost || !isValid(at, frame.goal()))
                continue;
            arrived.push_back(path);
            if (problem.figures(path).total < least)
            {
                least = problem.figures(path).total;
                best = path;
            }
        }
        for (auto &point : trail)
            point.second = std::max(1e-6, (1.0 - settings.evaporation) * point.second);
        for (int plane = 1; plane + 1 < frame.planes(); ++plane)
            for (std::size_t i = 0; i < frame.cellCount(); ++i)
                trail.emplace(std::make_pair(plane, i), std::pow(1.0 - settings.evaporation, iteration + 1));
        const auto lay = [&](const SlicePath &path, double amount)
        {
            for (std::size_t k = 0; k < path.size(); ++k)
                trail[{static_cast<int>(k) + 1, frame.index(path[k])}] += amount;
        };
        for (const SlicePath &path : arrived)
            lay(path, least / problem.figures(path).total);
        if (best)
            lay(*best, settings.elite);
    }
    return best;
}

TEST(AntColonySearch, WalksAsItsRulesSay)
{
    int found = 0;
    forEachSeed(40,
                [&](Random &random)
                {
                    const SliceStack stack = randomStack(random, randomFrame(random, {6, 6, 5}), random.real(0.0, 0.4));
                    const SliceProblem problem(stack, {random.real(0.2, 1.0), 1.0, 3});
                    const auto legs = randomLegs(random, random.real(0.5, 1.0));
                    AntSettings settings = fewAnts(static_cast<std::uint32_t>(random.integer(0, 1000)));
                    settings.evaporation = random.real(0.1, 0.9);
                    settings.elite = random.real(0.0, 5.0);
                    settings.alpha = random.real(0.0, 2.0);
                    settings.beta = random.real(0.0, 6.0);
                    settings.reach = static_cast<int>(random.integer(1, 5));
                    AntColonySearch ants(problem, settings);
                    RecordingJudge judge(legs);
                    finish(ants, judge);
                    EXPECT_EQ(ants.best(), literalAnts(problem, settings, legs));
                    found += ants.best() ? 1 : 0;
                });
    EXPECT_GT(found, 25);
}

TEST(AntColonySearch, TheSeedDecides)
{
    int differing = 0;
    forEachSeed(20,
                [&](Random &random)
                {
                    const SliceStack stack = randomStack(random, randomFrame(random, {7, 7, 6}), 0.2);
                    const SliceProblem problem(stack, {});
                    const auto pathOf = [&](std::uint32_t seed)
                    {
                        AntColonySearch ants(problem, fewAnts(seed));
                        RecordingJudge judge(everyLeg());
                        finish(ants, judge);
                        return ants.best();
                    };
                    const auto path = pathOf(1);
                    EXPECT_EQ(path, pathOf(1));
                    differing += path == pathOf(2) ? 0 : 1;
                });
    EXPECT_GT(differing, 10);
}

TEST(AntColonySearch, InterruptionsChangeNothing)
{
    forEachSeed(30,
                [](Random &random)
                {
                    const SliceStack stack = randomStack(random, randomFrame(random, {6, 5, 5}), 0.3);
                    const SliceProblem problem(stack, randomCriterion(random));
                    const auto legs = randomLegs(random, random.real(0.2, 1.0));
                    AntColonySearch atOnce(problem, fewAnts(1));
                    AntColonySearch inPieces(problem, fewAnts(1));
                    RecordingJudge patient(legs);
                    RecordingJudge hasty(legs, 1);
                    finish(atOnce, patient);
                    EXPECT_GE(finish(inPieces, hasty), static_cast<int>(patient.legs()) - 1);
                    EXPECT_EQ(atOnce.best(), inPieces.best());
                    EXPECT_EQ(atOnce.farthestPlane(), inPieces.farthestPlane());
                    EXPECT_LE(hasty.mostRepeats(), 1);
                });
}

/// With a trail to follow, ants come nearer to the least F than as many ants that know of no other.
TEST(AntColonySearch, TrailsAreWorthFollowing)
{
    double followed = 0.0;
    double ignored = 0.0;
    forEachSeed(8,
                [&](Random &random)
                {
                    const SliceStack stack = randomStack(random, randomFrame(random, {16, 12, 12}), 0.1);
                    const SliceProblem problem(stack, {});
                    const auto totalOf = [&](double alpha)
                    {
                        AntSettings settings;
                        settings.ants = 20;
                        settings.iterations = 40;
                        settings.alpha = alpha;
                        AntColonySearch ants(problem, settings);
                        RecordingJudge judge(everyLeg());
                        finish(ants, judge);
                        return ants.best() ? problem.figures(*ants.best()).total : 100.0;
                    };
                    followed += totalOf(1.0);
                    ignored += totalOf(0.0);
                });
    EXPECT_LT(followed, 0.95 * ignored);
}

TEST(AntColonySearch, AntsStayWithinReach)
{
    Random random(4);
    const SliceFrame frame = randomFrame(random, {8, 12, 12});
    const SliceProblem problem(SliceStack(frame), {});
    for (const int reach : {1, 3})
    {
        AntSettings settings = fewAnts(1);
        settings.reach = reach;
        AntColonySearch ants(problem, settings);
        RecordingJudge judge(everyLeg());
        while (ants.work(judge) == SliceSearch::Step::Better)
            for (std::size_t i = 1; i < ants.best()->size(); ++i)
            {
                EXPECT_LE(std::abs((*ants.best())[i].across - (*ants.best())[i - 1].across), reach);
                EXPECT_LE(std::abs((*ants.best())[i].level - (*ants.best())[i - 1].level), reach);
            }
        EXPECT_TRUE(ants.best());
    }
}

TEST(AntColonySearch, TellsHowFarAntsGot)
{
    Random random(5);
    SliceStack stack(randomFrame(random, {7, 5, 5}));
    for (std::size_t i = 0; i < stack.frame().cellCount(); ++i)
        stack.block(4, stack.frame().cell(i));
    const SliceProblem problem(stack, {});
    AntColonySearch ants(problem, fewAnts(1));
    RecordingJudge judge(everyLeg());
    EXPECT_EQ(ants.work(judge), SliceSearch::Step::Done);
    EXPECT_FALSE(ants.best());
    EXPECT_EQ(ants.farthestPlane(), 3);
}

}  // namespace
}  // namespace seahex::test
