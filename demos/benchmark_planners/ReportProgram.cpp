#include "ReportProgram.h"

#include "common/Failure.h"
#include "common/OwnFiles.h"

#include <array>
#include <cstdio>
#include <memory>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace benchmark_planners
{
namespace
{

struct CloseFile
{
    void operator()(std::FILE *file) const { std::fclose(file); }
};
using TemporaryFile = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void fail(const std::string &message)
{
    throw demos::Failure(demos::Exit::Report, message);
}

std::string contentOf(std::FILE *file)
{
    std::rewind(file);
    std::string content;
    std::array<char, 4096> buffer;
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), file)) > 0;)
        content.append(buffer.data(), n);
    while (!content.empty() && content.back() == '\n')
        content.pop_back();
    return content;
}

/// Runs a program; its standard error goes into a file.
/// @return its exit code; -1 if it can't be started or did not end by itself
int run(std::vector<std::string> command, std::FILE *errors)
{
    std::vector<char *> arguments;
    arguments.reserve(command.size() + 1);
    for (std::string &argument : command)
        arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, fileno(errors), STDERR_FILENO);
    pid_t process = -1;
    std::fflush(nullptr);
    const int error = posix_spawn(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    if (error != 0 || waitpid(process, &status, 0) != process || !WIFEXITED(status))
        return -1;
    return WEXITSTATUS(status);
}

}  // namespace

void makeReport(const Options &options, const std::vector<std::string> &folders)
{
    const char *const python = "/usr/bin/python3";  // Debian's: its packages belong to it and to no other Python
    const std::string logsStay = "; the logs are in " + options.out.string() + ", and --merge makes the page later";
    const std::string script = demos::ownFile("benchmark_report");
    if (script.empty())
        fail("the folder benchmark_report is neither in the build tree nor in the install tree of this program" +
             logsStay);
    if (access(python, X_OK) != 0)
        fail("python3 is missing: install the Debian packages python3-matplotlib and ompl-demos" + logsStay);

    std::vector<std::string> command = {python, "-B", script, "--out", options.out.string()};
    if (options.json)
        command.emplace_back("--json");
    command.emplace_back("--");
    command.insert(command.end(), folders.begin(), folders.end());
    const TemporaryFile errors(std::tmpfile());
    if (!errors)
        fail("no temporary file" + logsStay);
    const int code = run(command, errors.get());
    if (code == 0)
        return;
    const std::string said = contentOf(errors.get());
    const bool isSentence =
        code == static_cast<int>(demos::Exit::Report) || code == static_cast<int>(demos::Exit::Usage);
    if (isSentence && !said.empty())
        throw demos::Failure(static_cast<demos::Exit>(code), said);
    fail("the report program failed with code " + std::to_string(code) + ": " +
         said.substr(said.rfind('\n') == std::string::npos ? 0 : said.rfind('\n') + 1) + logsStay);
}

}  // namespace benchmark_planners
