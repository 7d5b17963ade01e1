#include "Program.h"

#include "Failure.h"

#include <nlohmann/json.hpp>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

namespace demos
{
namespace
{

bool wantsJson(int argc, const char *const *argv)
{
    for (int i = 1; i < argc; ++i)
        if (std::strcmp(argv[i], "--json") == 0 || std::strncmp(argv[i], "--json=", 7) == 0)
            return true;
    return false;
}

/// Status, exit, message, and the chart's warnings if there are any.
std::string jsonFailure(const Failure &failure)
{
    using Json = nlohmann::ordered_json;
    Json report = {{"status", statusWord(failure.exit())},
                   {"exit", static_cast<int>(failure.exit())},
                   {"message", failure.what()}};
    if (!failure.warnings().empty())
        report["warnings"] = failure.warnings();
    return report.dump(2, ' ', false, Json::error_handler_t::replace);
}

int fail(bool json, const Failure &failure)
{
    const bool isPrinted = json && std::puts(jsonFailure(failure).c_str()) >= 0 && std::fflush(stdout) == 0;
    if (!isPrinted)
    {
        for (const std::string &warning : failure.warnings())
            spdlog::warn(warning);
        spdlog::error(failure.what());
    }
    return static_cast<int>(failure.exit());
}

}  // namespace

int runProgram(const std::string &name, int argc, const char *const *argv, const std::function<void()> &work)
{
    spdlog::set_default_logger(spdlog::stderr_color_mt(name));
    spdlog::set_pattern("%n: %^%l%$: %v");
    const bool json = wantsJson(argc, argv);
    try
    {
        work();
        return static_cast<int>(Exit::Success);
    }
    catch (const Failure &failure)
    {
        return fail(json, failure);
    }
    catch (const std::bad_alloc &)
    {
        return fail(json, Failure(Exit::Usage, "not enough memory: a larger --pitch needs less"));
    }
    catch (const std::exception &error)
    {
        return fail(json, Failure(Exit::Internal, std::string("internal error: ") + error.what()));
    }
}

void print(const std::string &text)
{
    if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
        throw Failure(Exit::Internal, "can't write to standard output");
}

}  // namespace demos
