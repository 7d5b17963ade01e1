#pragma once

#include "JobProcess.h"
#include "Options.h"
#include "Ticker.h"
#include "World.h"

#include <deque>
#include <map>
#include <vector>

namespace benchmark_planners
{

/// Runs the jobs of a shard that are not done yet, several at a time, each in a process and on a core of its own. A
/// pair whose process dies is run once more, a process a planner; what dies then is recorded as crashed.
class Campaign
{
public:
    Campaign(const Options &options, const World &world, const ResultsFolder &folder);

    /// The jobs of the shard, done before or not.
    std::size_t jobCount() const { return ofShard_; }

    /// @throws demos::Failure
    void run();

private:
    struct Task
    {
        unsigned pair = 0;
        std::vector<std::string> planners;
        bool isAlone = false;
    };

    /// A core's place: what is running there.
    struct Slot
    {
        CoreLease core;
        std::optional<JobProcess> process;
    };

    void start(Slot &slot);
    void end(const JobProcess &process, const JobEnd &end);
    void runAlone(const Task &task);
    void leaseCores();
    bool isRunning() const;

    const Options &options_;
    const World &world_;
    const ResultsFolder &folder_;
    std::size_t ofShard_ = 0;
    std::deque<Task> waiting_;
    std::vector<Slot> slots_;
    std::map<unsigned, JobRecord> records_;      // of pairs that are being worked on
    std::map<unsigned, std::size_t> remaining_;  // tasks of theirs
    Ticker ticker_;
};

}  // namespace benchmark_planners
