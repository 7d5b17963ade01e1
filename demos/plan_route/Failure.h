#pragma once

#include <stdexcept>
#include <string>

namespace plan_route
{

/// The program's exit codes, as its help documents them.
enum class Exit
{
    Route = 0,
    Internal = 1,
    Usage = 2,
    Chart = 3,
    NotNavigable = 4,
    NoRoute = 5,
    OutOfTime = 6
};

/// The word for an exit code in the field `status` of --json.
const char *statusWord(Exit exit);

/// Ends the program with an exit code and one sentence.
class Failure : public std::runtime_error
{
public:
    Failure(Exit exit, const std::string &message) : std::runtime_error(message), exit_(exit) {}
    Exit exit() const { return exit_; }

private:
    Exit exit_;
};

}  // namespace plan_route
