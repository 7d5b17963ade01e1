#pragma once

#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace demos
{

/// Parses a command line into what the program has declared.
/// @return the help text if that was asked for
/// @throws Failure (Exit::Usage) with one sentence
std::optional<std::string> parseCommandLine(CLI::App &app, int argc, const char *const *argv);

}  // namespace demos
