#pragma once

#include "Cores.h"
#include "Job.h"
#include "ResultsFolder.h"

#include <chrono>
#include <optional>
#include <string>

#include <sys/types.h>

namespace benchmark_planners
{

/// How a job's process ended.
struct JobEnd
{
    bool isDone = false;  ///< the log is there
    std::string how;      ///< if not: a signal's name, "exit code 1", "did not stop in time"
    std::string said;     ///< if not: the last line on standard error
    double seconds = 0.0;
};

/// A job in a forked process, which inherits the world and ends with its parent. The log appears under its name when it
/// is whole.
class JobProcess
{
public:
    /// @param isAlone  the log is named after the job's only planner
    /// @throws demos::Failure (Exit::Internal) if no process can be made
    JobProcess(const World &world, const Job &job, const ResultsFolder &folder, bool isAlone, const CoreLease &core);
    JobProcess(JobProcess &&) = default;
    JobProcess &operator=(JobProcess &&) = default;

    /// Empty while it runs. A process far beyond its time is killed.
    std::optional<JobEnd> poll();

    const Job &job() const { return job_; }
    bool isAlone() const { return isAlone_; }
    const std::filesystem::path &log() const { return log_; }

private:
    using Clock = std::chrono::steady_clock;

    [[noreturn]] void runAsChild(const World &world, const CoreLease &core, pid_t parent) const;
    std::string lastWords() const;

    Job job_;
    bool isAlone_;
    std::filesystem::path log_;
    std::filesystem::path part_;
    std::filesystem::path errors_;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point deadline_;
    bool isKilled_ = false;
    pid_t process_ = -1;
};

}  // namespace benchmark_planners
