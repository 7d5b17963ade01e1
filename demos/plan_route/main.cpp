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

int fail(bool json, Exit exit, const std::string &message)
{
    if (json)
        std::puts(plan_route::jsonFailure(exit, message).c_str());
    else
        spdlog::error(message);
    return static_cast<int>(exit);
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
    std::fputs((options.json ? plan_route::jsonReport(options, result) + "\n" : plan_route::textReport(options, result))
                   .c_str(),
               stdout);
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
            std::fputs(commandLine.text.c_str(), stdout);
            return 0;
        }
        run(*commandLine.options);
        return 0;
    }
    catch (const plan_route::Failure &failure)
    {
        return fail(json, failure.exit(), failure.what());
    }
    catch (const std::bad_alloc &)
    {
        return fail(json, Exit::Usage, "not enough memory: a larger --pitch needs less");
    }
    catch (const std::exception &error)
    {
        return fail(json, Exit::Internal, std::string("internal error: ") + error.what());
    }
}
