// plan_dive: a safe dive from A to B over a real seabed. The options are in Options.cpp, the work in Job.cpp.

#include "Drawing.h"
#include "Job.h"
#include "Options.h"
#include "Report.h"
#include "common/Program.h"
#include "common/Progress.h"

namespace
{

void run(const plan_dive::Options &options)
{
    demos::Progress progress;
    const plan_dive::Result result = plan_dive::planDive(options, progress);
    progress.stage("writing");
    if (!options.out.empty())
        plan_dive::writeDiveFile(options, result);
    if (!options.profile.empty())
        plan_dive::drawProfile(options, result);
    if (!options.picture.empty())
        plan_dive::drawSeabed(options, result);
    progress.end();
    demos::print(options.json ? plan_dive::jsonReport(options, result) + "\n" : plan_dive::textReport(options, result));
}

}  // namespace

int main(int argc, char **argv)
{
    return demos::runProgram("plan_dive", argc, argv,
                             [argc, argv]
                             {
                                 const plan_dive::CommandLine commandLine = plan_dive::readCommandLine(argc, argv);
                                 if (commandLine.options)
                                     run(*commandLine.options);
                                 else
                                     demos::print(commandLine.text);
                             });
}
