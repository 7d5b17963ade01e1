#include "CommandLine.h"

#include "Failure.h"

#include <CLI/CLI.hpp>

namespace demos
{

std::optional<std::string> parseCommandLine(CLI::App &app, int argc, const char *const *argv)
{
    try
    {
        app.parse(argc, argv);
        return std::nullopt;
    }
    catch (const CLI::CallForHelp &)
    {
        return app.help();
    }
    catch (const CLI::ParseError &error)
    {
        throw Failure(Exit::Usage, error.what());
    }
}

}  // namespace demos
