#include "support/RunProgram.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace seahex::test
{
namespace
{

using Clock = std::chrono::steady_clock;

struct CloseFile
{
    void operator()(std::FILE *file) const { std::fclose(file); }
};

/// A file without a name. Programs write into files rather than pipes, which fill up and then block.
using TemporaryFile = std::unique_ptr<std::FILE, CloseFile>;

TemporaryFile temporaryFile()
{
    TemporaryFile file(std::tmpfile());
    if (!file)
        throw std::runtime_error(std::string("no temporary file: ") + std::strerror(errno));
    return file;
}

std::string contentOf(std::FILE *file)
{
    std::rewind(file);
    std::string content;
    char buffer[4096];
    for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, file)) > 0;)
        content.append(buffer, n);
    return content;
}

constexpr int EXIT_CANNOT_START = 127;

/// Runs in the child: only functions that are safe between fork and exec.
[[noreturn]] void become(char *const *arguments, const char *folder, int out, int err)
{
    const int in = open("/dev/null", O_RDONLY);
    const bool ready = in >= 0 && dup2(in, STDIN_FILENO) >= 0 && dup2(out, STDOUT_FILENO) >= 0 &&
                       dup2(err, STDERR_FILENO) >= 0 && (*folder == '\0' || chdir(folder) == 0);
    if (ready)
        execv(arguments[0], arguments);
    _exit(EXIT_CANNOT_START);
}

/// The child's wait status; kills it when the time is over.
int waitFor(pid_t child, Clock::time_point end, bool &timedOut)
{
    for (;;)
    {
        int status = 0;
        const pid_t ended = waitpid(child, &status, timedOut ? 0 : WNOHANG);
        if (ended == child)
            return status;
        if (ended < 0 && errno != EINTR)
            throw std::runtime_error(std::string("waiting for a program failed: ") + std::strerror(errno));
        if (!timedOut && Clock::now() > end)
        {
            timedOut = true;
            kill(child, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

}  // namespace

std::string ProgramResult::summary() const
{
    std::string text = "exit code " + std::to_string(exitCode);
    if (timedOut)
        text = "killed because its time was over";
    else if (signal != 0)
        text = std::string("ended by signal: ") + strsignal(signal);
    return text + "\n--- standard output\n" + out + "--- standard error\n" + err;
}

ProgramResult runProgram(const std::vector<std::string> &command, const std::filesystem::path &workingFolder,
                         std::chrono::seconds limit)
{
    if (command.empty() || access(command.front().c_str(), X_OK) != 0)
        throw std::runtime_error("no program to run: '" + (command.empty() ? std::string() : command.front()) + "'");
    std::vector<std::string> copies = command;
    std::vector<char *> arguments;
    for (std::string &argument : copies)
        arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    const std::string folder = workingFolder.string();
    const TemporaryFile out = temporaryFile();
    const TemporaryFile err = temporaryFile();

    const pid_t child = fork();
    if (child < 0)
        throw std::runtime_error(std::string("no process: ") + std::strerror(errno));
    if (child == 0)
        become(arguments.data(), folder.c_str(), fileno(out.get()), fileno(err.get()));

    ProgramResult result;
    const int status = waitFor(child, Clock::now() + limit, result.timedOut);
    if (WIFEXITED(status))
        result.exitCode = WEXITSTATUS(status);
    if (WIFSIGNALED(status))
        result.signal = WTERMSIG(status);
    result.out = contentOf(out.get());
    result.err = contentOf(err.get());
    if (result.exitCode == EXIT_CANNOT_START)
        throw std::runtime_error("'" + command.front() + "' can't be started in '" + folder + "'");
    return result;
}

}  // namespace seahex::test
