#include "support/StateSpaceConformance.h"

#include "support/SpaceTrial.h"

#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include <cmath>
#include <limits>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

void checkCopies(SpaceTrial &trial)
{
    const HeldState &a = trial.pool.front();
    for (const HeldState &b : trial.pool)
    {
        const HeldState copy(trial.space, a.get());
        if (!trial.space->equalStates(copy.get(), a.get()) || !trial.space->equalStates(a.get(), a.get()))
            trial.report.broken("copies", "a copy is not equal to " + trial.text(a.get()));
        trial.space->copyState(copy.get(), b.get());
        if (!trial.space->equalStates(copy.get(), b.get()))
            trial.report.broken("copies", "a second copy is not equal to " + trial.text(b.get()));
        ob::State *clone = trial.space->cloneState(b.get());
        if (!trial.space->equalStates(clone, b.get()))
            trial.report.broken("copies", "a clone is not equal to " + trial.text(b.get()));
        trial.space->freeState(clone);
    }
}

void checkDistances(SpaceTrial &trial)
{
    const ob::StateSpace &space = *trial.space;
    const SpacePromises &promises = trial.promises;
    for (const HeldState &a : trial.pool)
        for (const HeldState &b : trial.pool)
        {
            const auto pair = [&]
            {
                return trial.text(a.get()) + ", " + trial.text(b.get());
            };
            const double distance = space.distance(a.get(), b.get());
            if (!(std::abs(distance - promises.distance(a.reals(), b.reals())) <= promises.rounding))
                trial.report.broken("distance", std::to_string(distance) + " between " + pair());
            if (space.equalStates(a.get(), b.get()) ? distance > promises.rounding : !(distance > 0.0))
                trial.report.broken("distance", "0 for equal states only: " + pair());
            if (space.hasSymmetricDistance() && distance != space.distance(b.get(), a.get()))
                trial.report.broken("distance", "not symmetric: " + pair());
            if (!(distance <= space.getMaximumExtent()))
                trial.report.broken("extent", "smaller than the distance between " + pair());
            const HeldState &c = trial.any(trial.pool);
            if (space.isMetricSpace() &&
                distance > space.distance(a.get(), c.get()) + space.distance(c.get(), b.get()) + promises.rounding)
                trial.report.broken("metric", "a way round by " + trial.text(c.get()) + " is shorter: " + pair());
        }
    if (!(std::abs(space.getMaximumExtent() - promises.extent) <= promises.rounding))
        trial.report.broken("extent",
                            std::to_string(space.getMaximumExtent()) + ", not " + std::to_string(promises.extent));
    if (!(std::abs(space.getMeasure() - promises.measure) <= 1e-9 * promises.measure))
        trial.report.broken("measure",
                            std::to_string(space.getMeasure()) + ", not " + std::to_string(promises.measure));
}

void checkBounds(SpaceTrial &trial)
{
    const ob::StateSpace &space = *trial.space;
    for (const HeldState &state : trial.pool)
    {
        if (!space.satisfiesBounds(state.get()))
            trial.report.broken("bounds", "not within: " + trial.text(state.get()));
        const HeldState enforced(trial.space, state.get());
        space.enforceBounds(enforced.get());
        if (!space.equalStates(enforced.get(), state.get()))
            trial.report.broken("bounds", "enforced on a state within: " + trial.text(state.get()));
    }
    for (const Reals &reals : trial.promises.outside)
    {
        const HeldState state(trial.space, reals);
        if (space.satisfiesBounds(state.get()))
            trial.report.broken("bounds", "within: " + trial.text(state.get()));
        space.enforceBounds(state.get());
        if (!space.satisfiesBounds(state.get()))
            trial.report.broken("bounds", "enforced, and yet out: " + trial.text(state.get()));
    }
}

void checkInterpolation(SpaceTrial &trial, const HeldState &a, const HeldState &b, double t)
{
    const ob::StateSpace &space = *trial.space;
    const auto where = [&]
    {
        return std::to_string(t) + " from " + trial.text(a.get()) + " to " + trial.text(b.get());
    };
    const HeldState state(trial.space);
    space.interpolate(a.get(), b.get(), t, state.get());
    if (!space.satisfiesBounds(state.get()))
        trial.report.broken("interpolation bounds", trial.text(state.get()) + " at " + where());
    if (t == 0.0 && !trial.same(state.get(), a.get()))
        trial.report.broken("interpolation ends", where());
    if (t == 1.0 && !trial.same(state.get(), b.get()))
        trial.report.broken("interpolation ends", where());

    const HeldState reverse(trial.space);
    space.interpolate(b.get(), a.get(), 1.0 - t, reverse.get());
    if (space.hasSymmetricInterpolate() && !trial.same(state.get(), reverse.get()))
        trial.report.broken("interpolation symmetry",
                            trial.text(state.get()) + " or " + trial.text(reverse.get()) + " at " + where());

    const HeldState overFrom(trial.space, a.get());
    space.interpolate(overFrom.get(), b.get(), t, overFrom.get());
    const HeldState overTo(trial.space, b.get());
    space.interpolate(a.get(), overTo.get(), t, overTo.get());
    if (!trial.same(overFrom.get(), state.get()) || !trial.same(overTo.get(), state.get()))
        trial.report.broken("interpolation overlap", where());

    const double length = space.distance(a.get(), b.get());
    const double slack = trial.promises.interpolationError + trial.promises.rounding;
    if (!(std::abs(space.distance(a.get(), state.get()) - t * length) <= slack) ||
        !(std::abs(space.distance(state.get(), b.get()) - (1.0 - t) * length) <= slack))
        trial.report.broken("interpolation line", trial.text(state.get()) + " at " + where());
}

void checkMotions(SpaceTrial &trial)
{
    constexpr double least = std::numeric_limits<double>::denorm_min();
    for (const HeldState &a : trial.pool)
        for (const HeldState &b : trial.pool)
            for (const double t : {0.0, 1.0, 0.5, 1.0 / 3.0, least, 1.0 - 0x1p-53, trial.random.unit()})
                checkInterpolation(trial, a, b, t);
}

void checkSegments(SpaceTrial &trial)
{
    ob::StateSpace &space = *trial.space;
    const unsigned int before = space.getValidSegmentCountFactor();
    for (const HeldState &a : trial.pool)
        for (const HeldState &b : trial.pool)
        {
            if (space.equalStates(a.get(), b.get()))
                continue;
            const auto pair = [&]
            {
                return trial.text(a.get()) + ", " + trial.text(b.get());
            };
            const unsigned int count = space.validSegmentCount(a.get(), b.get());
            if (count < 1)
                trial.report.broken("segments", "none between " + pair());
            if (count != space.validSegmentCount(b.get(), a.get()))
                trial.report.broken("segments", "another number on the way back: " + pair());
            space.setValidSegmentCountFactor(4 * before);
            if (trial.promises.countsFactor && space.validSegmentCount(a.get(), b.get()) != 4 * count)
                trial.report.broken("segments", "the factor does not count: " + pair());
            space.setValidSegmentCountFactor(before);
        }
}

void checkSerialisation(SpaceTrial &trial)
{
    const ob::StateSpace &space = *trial.space;
    const unsigned int length = space.getSerializationLength();
    if (length == 0)
        return trial.report.broken("serialisation", "length 0");
    // odd addresses, and guards before and behind
    constexpr char guard = 0x5a;
    constexpr std::size_t margin = 17;
    for (const HeldState &state : trial.pool)
    {
        std::vector<char> first(length + 2 * margin, guard);
        std::vector<char> second(length + 2 * margin, guard);
        space.serialize(first.data() + margin, state.get());
        const HeldState again(trial.space, trial.pool.front().get());
        space.deserialize(again.get(), first.data() + margin);
        if (!space.equalStates(again.get(), state.get()))
            trial.report.broken("serialisation", trial.text(state.get()) + " became " + trial.text(again.get()));
        space.serialize(second.data() + margin, again.get());
        if (first != second)
            trial.report.broken("serialisation", "equal states in different bytes");
        for (std::size_t i = 0; i < margin; ++i)
            if (first[i] != guard || first[first.size() - 1 - i] != guard)
                trial.report.broken("serialisation", "written beyond its length");
    }
}

void checkReals(SpaceTrial &trial)
{
    for (const HeldState &state : trial.pool)
    {
        const Reals reals = state.reals();
        if (reals.size() != trial.space->getDimension())
            trial.report.broken("reals", std::to_string(reals.size()) + " in dimension " +
                                             std::to_string(trial.space->getDimension()));
        const HeldState again(trial.space, reals);
        if (!trial.space->equalStates(again.get(), state.get()) || again.reals() != reals)
            trial.report.broken("reals", trial.text(state.get()) + " became " + trial.text(again.get()));
    }
}

std::vector<int> signatureOf(const ob::StateSpace &space)
{
    std::vector<int> signature;
    space.computeSignature(signature);
    return signature;
}

void checkSignature(SpaceTrial &trial, const SpaceFactory &makeSpace)
{
    const std::vector<int> signature = signatureOf(*trial.space);
    if (signature.empty() || signature.front() != static_cast<int>(signature.size()) - 1)
        trial.report.broken("signature", "does not begin with the number of integers that follow");
    const ob::StateSpacePtr twin = makeSpace();
    if (signatureOf(*twin) != signature)
        trial.report.broken("signature", "another one for the same space");
    if (twin->getName() == trial.space->getName())
        trial.report.broken("names", "two spaces are called " + twin->getName());
    for (const ob::StateSpacePtr &other : trial.promises.others)
        if (signatureOf(*other) == signature)
            trial.report.broken("signature", "that of " + other->getName() + " as well");
}

void checkProjection(SpaceTrial &trial)
{
    if (!trial.space->hasDefaultProjection())
        return trial.report.broken("projection", "none");
    const auto projection = trial.space->getDefaultProjection();
    const unsigned int dimension = projection->getDimension();
    for (const double size : projection->getCellSizes())
        if (projection->getCellSizes().size() != dimension || !(size > 0.0) || !std::isfinite(size))
            trial.report.broken("projection", "cell size " + std::to_string(size));
    std::vector<Eigen::VectorXd> points;
    for (const HeldState &state : trial.pool)
    {
        points.emplace_back(Eigen::VectorXd::Constant(dimension, std::nan("")));
        projection->project(state.get(), points.back());
        if (!points.back().allFinite())
            trial.report.broken("projection", "of " + trial.text(state.get()));
        if (trial.space->distance(state.get(), trial.pool.front().get()) > 0.5 * trial.promises.extent &&
            points.back() == points.front())
            trial.report.broken("projection", "one point for states far apart");
    }
    std::vector<double> sizes = projection->getCellSizes();
    for (double &size : sizes)
        size *= 3.0;
    projection->setCellSizes(sizes);
    trial.space->setup();
    if (trial.space->getDefaultProjection()->getCellSizes() != sizes)
        trial.report.broken("projection", "setup() forgets the user's cell sizes");
}

void checkSetup(SpaceTrial &trial)
{
    const auto settings = [&space = *trial.space]
    {
        std::vector<double> values = {space.getMaximumExtent(), space.getMeasure(),
                                      space.getLongestValidSegmentLength(), space.getLongestValidSegmentFraction(),
                                      static_cast<double>(space.getRegisteredProjections().size())};
        for (const int part : signatureOf(space))
            values.push_back(part);
        return values;
    };
    const std::vector<double> before = settings();
    for (int i = 0; i < 3; ++i)
        trial.space->setup();
    if (settings() != before)
        trial.report.broken("setup", "a second one changes the space");
    if (!(trial.space->getLongestValidSegmentLength() > 0.0))
        trial.report.broken("setup", "no longest valid segment");
}

void checkSanity(SpaceTrial &trial)
{
    try
    {
        trial.space->sanityChecks();
        trial.space->sanityChecks(std::numeric_limits<double>::epsilon(), std::numeric_limits<float>::epsilon(),
                                  trial.promises.sanityFlags);
    }
    catch (const ompl::Exception &failure)
    {
        trial.report.broken("sanity checks", failure.what());
    }
}

void checkPrinting(SpaceTrial &trial)
{
    std::ostringstream state;
    trial.space->printState(trial.pool.front().get(), state);
    if (state.str().size() < 2 || state.str().back() != '\n')
        trial.report.broken("printing", "a state is not a line: " + state.str());
    std::ostringstream settings;
    trial.space->printSettings(settings);
    if (settings.str().find(trial.space->getName()) == std::string::npos)
        trial.report.broken("printing", "the settings don't name the space: " + settings.str());
}

/// All states of a small space, some of a large one.
void fillPool(SpaceTrial &trial)
{
    const std::vector<Reals> &every = trial.promises.everyState;
    if (!every.empty() && every.size() <= 60)
        for (const Reals &state : every)
            trial.pool.emplace_back(trial.space, state);
    else
        for (int i = 0; i < 24; ++i)
            trial.pool.emplace_back(trial.space, every.empty() ? trial.promises.state(trial.random) : trial.any(every));
}

void runChecks(SpaceTrial &trial, const SpaceFactory &makeSpace)
{
    trial.space->setup();
    fillPool(trial);
    checkCopies(trial);
    checkDistances(trial);
    checkBounds(trial);
    checkMotions(trial);
    checkSegments(trial);
    checkSerialisation(trial);
    checkReals(trial);
    checkSignature(trial, makeSpace);
    checkSetup(trial);
    if (trial.promises.projects)
        checkProjection(trial);
    checkPrinting(trial);
    checkSamplers(trial);
    // OMPL's own leave their states behind where they fail
    if (trial.report.failures().empty())
        checkSanity(trial);
    trial.pool.clear();
}

}  // namespace

std::vector<std::string> conformanceFailures(const SpaceFactory &makeSpace, const SpacePromises &promises,
                                             std::uint64_t seed)
{
    // OMPL would tell the console about every exception that is caught here
    const ompl::msg::LogLevel level = ompl::msg::getLogLevel();
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ConformanceReport report;
    const ob::StateSpacePtr space = makeSpace();
    SpaceTrial trial{space, promises, report, Random(seed), {}};
    try
    {
        runChecks(trial, makeSpace);
    }
    catch (const std::exception &failure)
    {
        trial.pool.clear();
        report.broken("exceptions", failure.what());
    }
    const auto *count = dynamic_cast<const StateCount *>(space.get());
    if (count == nullptr || count->alive() != 0)
        report.broken("states", count == nullptr ? "not counted" : std::to_string(count->alive()) + " never freed");
    ompl::msg::setLogLevel(level);
    return report.failures();
}

}  // namespace seahex::test
