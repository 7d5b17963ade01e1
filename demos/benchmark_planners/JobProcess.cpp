#include "JobProcess.h"

#include "common/Failure.h"
#include "common/WholeFile.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <system_error>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace benchmark_planners
{
namespace
{

namespace fs = std::filesystem;

/// Exit codes of the child.
enum ChildExit
{
    Done = 0,
    Failed = 1,
    CannotWrite = 2
};

/// Far more than a run's limit, for what Benchmark does around the runs, and for slow machines.
std::chrono::duration<double> patience(const Job &job)
{
    const double runs = static_cast<double>(job.planners.size()) * job.runs;
    return std::chrono::duration<double>(60.0 + runs * (10.0 + 2.0 * job.timeS));
}

std::string describeEnd(int status)
{
    if (WIFSIGNALED(status))
        return strsignal(WTERMSIG(status));
    return "exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

JobProcess::JobProcess(const World &world, const Job &job, const ResultsFolder &folder, bool isAlone,
                       const CoreLease &core)
    : job_(job), isAlone_(isAlone), log_(isAlone ? folder.log(job.pair, job.planners.front()) : folder.log(job.pair)),
      part_(demos::partName(log_)), errors_(part_.string() + ".err"),
      deadline_(begin_ + std::chrono::duration_cast<Clock::duration>(patience(job)))
{
    std::fflush(nullptr);  // or the child would write the parent's buffers once more
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ < 0)
        throw demos::Failure(demos::Exit::Internal, std::string("no process for a job: ") + std::strerror(errno));
    if (process_ == 0)
        runAsChild(world, core, parent);
}

void JobProcess::runAsChild(const World &world, const CoreLease &core, pid_t parent) const
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(Failed);
    core.pinThisProcess();
    const int errors = open(errors_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (errors < 0 || dup2(errors, STDERR_FILENO) < 0 || dup2(nothing, STDOUT_FILENO) < 0)
        _exit(CannotWrite);
    // _exit: what the parent has still to do at its end is not the child's, and OMPL's planners leak.
    try
    {
        std::ofstream log(part_);
        if (!runJob(world, job_, log_.stem().string(), log))
            _exit(CannotWrite);
        log.close();
        fs::rename(part_, log_);
        _exit(log ? Done : CannotWrite);
    }
    catch (const std::exception &error)
    {
        std::cerr << error.what() << std::endl;
        _exit(Failed);
    }
}

std::optional<JobEnd> JobProcess::poll()
{
    int status = 0;
    const pid_t ended = waitpid(process_, &status, WNOHANG);
    if (ended == 0)
    {
        if (!isKilled_ && Clock::now() > deadline_)
        {
            isKilled_ = true;
            kill(process_, SIGKILL);
        }
        return std::nullopt;
    }
    if (ended < 0)
        throw demos::Failure(demos::Exit::Internal, std::string("waiting for a job failed: ") + std::strerror(errno));

    JobEnd end;
    end.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    end.isDone = WIFEXITED(status) && WEXITSTATUS(status) == Done;
    if (!end.isDone)
    {
        end.how = isKilled_ ? "did not stop in time" : describeEnd(status);
        end.said = lastWords();
    }
    std::error_code ignored;
    fs::remove(errors_, ignored);
    fs::remove(part_, ignored);
    if (WIFEXITED(status) && WEXITSTATUS(status) == CannotWrite)
        throw demos::Failure(demos::Exit::Usage, "can't write " + log_.string());
    return end;
}

std::string JobProcess::lastWords() const
{
    constexpr std::size_t most = 300;
    std::ifstream file(errors_);
    std::string last;
    for (std::string line; std::getline(file, line);)
        if (!line.empty())
            last = line;
    return last.size() > most ? last.substr(0, most) + "..." : last;
}

}  // namespace benchmark_planners
