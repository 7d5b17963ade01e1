// plan_route: a safe route from A to B on a nautical chart. The options are in Options.cpp, the work in Job.cpp.

#include "Drawing.h"
#include "Failure.h"
#include "Job.h"
#include "Options.h"
#include "Progress.h"
#include "Report.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <exception>

namespace
{

using plan_route::Exit;
using plan_route::Failure;

/// @throws Failure if it can't be written: a result that nobody gets is none
void print(const std::string &text)
{
    if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
        throw Failure(Exit::Internal, "can't write to standard output");
}

int fail(bool json, const Failure &failure)
{
    const bool isPrinted = json && std::puts(plan_route::jsonFailure(failure).c_str()) >= 0 && std::fflush(stdout) == 0;
    if (!isPrinted)
    {
        for (const std::string &warning : failure.warnings())
            spdlog::warn(warning);
        spdlog::error(failure.what());
    }
    return static_cast<int>(failure.exit());
}

void run(const plan_route::Options &options)
{
    plan_route::Progress progress;
    const plan_route::Result result = plan_route::planRoute(options, progress);
    progress.stage("writing");
    if (!options.out.empty())
        plan_route::writeRouteFile(options, result);
    if (!options.picture.empty())
        plan_route::drawPicture(options, result);
    progress.end();
    print(options.json ? plan_route::jsonReport(options, result) + "\n" : plan_route::textReport(options, result));
}

}  // namespace

int main(int argc, char **argv)
{
    spdlog::set_default_logger(spdlog::stderr_color_mt("plan_route"));
    spdlog::set_pattern("%n: %^%l%$: %v");
    const bool json = plan_route::wantsJson(argc, argv);
    try
    {
        const plan_route::CommandLine commandLine = plan_route::readCommandLine(argc, argv);
        if (!commandLine.options)
        {
            print(commandLine.text);
            return 0;
        }
        run(*commandLine.options);
        return 0;
    }
    catch (const plan_route::Failure &failure)
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
