// reproduce_papers: the experiments of [Cheng2020], [Wang2017] and [Xu]. One file an experiment: ChengStudy.cpp,
// WangStudy.cpp, XuStudy.cpp, ClaimsStudy.cpp; the claims of the former two are listed in Claims.cpp.

#include "ChengStudy.h"
#include "ClaimsStudy.h"
#include "Options.h"
#include "Output.h"
#include "WangStudy.h"
#include "XuStudy.h"
#include "common/Program.h"
#include "common/Progress.h"

#include <ompl/util/Console.h>

namespace
{

using namespace reproduce_papers;

void run(const Options &options)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const Output output(options.out, options.format);
    demos::Progress progress;
    progress.stage("[Cheng2020]");
    const Study cheng = chengStudy();
    progress.stage("[Wang2017]");
    const Study wang = wangStudy();
    progress.stage("[Xu]");
    const Study xu = xuStudy(options.xu);
    const std::vector<ChartTrials> trials = runTrials(options.claims, progress);
    progress.stage("drawing");
    std::vector<Table> tables = cheng.tables;
    tables.insert(tables.end(), wang.tables.begin(), wang.tables.end());
    for (const Table &table : claimTables(trials))
        tables.push_back(table);
    tables.insert(tables.end(), xu.tables.begin(), xu.tables.end());
    for (const Study *study : {&cheng, &wang})
        for (const Figure &figure : study->figures)
            output.draw(figure);
    for (const SeabedFigure &figure : xu.seabeds)
        output.draw(figure);
    const nlohmann::ordered_json report = output.writeReport(tables, claimsJson(trials));
    progress.end();
    if (options.json)
        return demos::print(report.dump(2) + "\n");
    for (const Table &table : tables)
        demos::print(toText(table) + "\n");
    demos::print("wrote " + output.summary() + "\n");
}

}  // namespace

int main(int argc, char **argv)
{
    return demos::runProgram("reproduce_papers", argc, argv,
                             [argc, argv]
                             {
                                 const CommandLine commandLine = readCommandLine(argc, argv);
                                 if (commandLine.options)
                                     run(*commandLine.options);
                                 else
                                     demos::print(commandLine.text);
                             });
}
