#pragma once

#include "ClaimsStudy.h"
#include "XuStudy.h"

#include <optional>
#include <string>

namespace reproduce_papers
{

/// What the command line asks for, checked.
struct Options
{
    ClaimsOptions claims;
    XuOptions xu;
    std::string out = "reproduction";
    std::string format = "png";
    bool json = false;
};

struct CommandLine
{
    std::optional<Options> options;
    std::string text;  ///< help, where that was asked for
};

/// @throws demos::Failure (Exit::Usage) with one sentence, (Exit::Chart) if a folder of charts can't be read
CommandLine readCommandLine(int argc, const char *const *argv);

}  // namespace reproduce_papers
