#include "Campaign.h"

#include <algorithm>
#include <thread>

namespace benchmark_planners
{

Campaign::Campaign(const Options &options, const World &world, const ResultsFolder &folder)
    : options_(options), world_(world), folder_(folder)
{
    for (unsigned pair = 1; pair <= world.pairCount(); ++pair)
    {
        if (options.shard && !options.shard->contains(pair - 1))
            continue;
        ++ofShard_;
        if (!folder.isDone(pair))
            waiting_.push_back({pair, options.planners});
    }
}

void Campaign::run()
{
    leaseCores();
    ticker_.begin(ofShard_, ofShard_ - waiting_.size(), slots_.size());
    while (!waiting_.empty() || isRunning())
    {
        for (Slot &slot : slots_)
        {
            if (!slot.process && !waiting_.empty())
                start(slot);
            if (!slot.process)
                continue;
            if (const std::optional<JobEnd> ended = slot.process->poll())
            {
                const JobProcess process = std::move(*slot.process);
                slot.process.reset();
                end(process, *ended);
            }
        }
        ticker_.tick();
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ticker_.end();
}

void Campaign::leaseCores()
{
    const std::size_t wanted = std::min<std::size_t>(options_.jobs, waiting_.size());
    std::size_t missing = 0;
    for (std::size_t i = 0; i < wanted; ++i)
    {
        slots_.push_back({CoreLease::take(), std::nullopt});
        missing += slots_.back().core.hasCore() ? 0 : 1;
    }
    if (missing > 0)
        ticker_.say("warning: " + std::to_string(missing) + " of " + std::to_string(wanted) +
                    " jobs at a time have no core of their own; their times are not to be compared");
}

void Campaign::start(Slot &slot)
{
    const Task task = waiting_.front();
    waiting_.pop_front();
    if (!task.isAlone)
    {
        records_[task.pair] = JobRecord();
        records_[task.pair].pair = task.pair;
        remaining_[task.pair] = 1;
    }
    const Job job = {task.pair, task.planners, options_.runs, options_.timeS, options_.seed};
    slot.process.emplace(world_, job, folder_, task.isAlone, slot.core);
}

void Campaign::end(const JobProcess &process, const JobEnd &end)
{
    const Job &job = process.job();
    JobRecord &record = records_.at(job.pair);
    record.seconds += end.seconds;
    if (end.isDone)
        record.logs.push_back(process.log().filename().string());
    else if (process.isAlone())
        record.crashes.push_back({job.planners.front(), end.how, end.said});
    else
    {
        ticker_.say("pair " + std::to_string(job.pair) + ": " + end.how +
                    (end.said.empty() ? "" : " (" + end.said + ")") + "; again, a process a planner");
        runAlone({job.pair, job.planners, true});
        return;
    }
    if (--remaining_.at(job.pair) > 0)
        return;
    std::sort(record.logs.begin(), record.logs.end());
    folder_.write(record);
    ticker_.jobDone(record);
    records_.erase(job.pair);
}

void Campaign::runAlone(const Task &task)
{
    remaining_.at(task.pair) = task.planners.size();
    for (const std::string &planner : task.planners)
        waiting_.push_front({task.pair, {planner}, true});
}

bool Campaign::isRunning() const
{
    return std::any_of(slots_.begin(), slots_.end(), [](const Slot &slot) { return slot.process.has_value(); });
}

}  // namespace benchmark_planners
