// plan_route: a safe route from A to B on a nautical chart. The options are in Options.cpp, the work in Job.cpp.

#include "Drawing.h"
#include "Job.h"
#include "Options.h"
#include "Report.h"
#include "common/Program.h"
#include "common/Progress.h"

namespace
{

void run(const plan_route::Options &options)
{
    demos::Progress progress;
    const plan_route::Result result = plan_route::planRoute(options, progress);
    progress.stage("writing");
    if (!options.out.empty())
        plan_route::writeRouteFile(options, result);
    if (!options.picture.empty())
        plan_route::drawPicture(options, result);
    progress.end();
    demos::print(options.json ? plan_route::jsonReport(options, result) + "\n"
                              : plan_route::textReport(options, result));
}

}  // namespace

int main(int argc, char **argv)
{
    return demos::runProgram("plan_route", argc, argv,
                             [argc, argv]
                             {
                                 const plan_route::CommandLine commandLine = plan_route::readCommandLine(argc, argv);
                                 if (commandLine.options)
                                     run(*commandLine.options);
                                 else
                                     demos::print(commandLine.text);
                             });
}
