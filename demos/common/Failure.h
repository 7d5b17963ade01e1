#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace demos
{

/// The exit codes of the programs of this folder, one meaning each; a program's help names those that it has.
enum class Exit
{
    Success = 0,
    Internal = 1,
    Usage = 2,
    Chart = 3,
    NotNavigable = 4,
    NoRoute = 5,
    OutOfTime = 6,
    Report = 7
};

/// The word for a failure's exit code in the field `status` of --json.
const char *statusWord(Exit exit);

/// A number for a message: "20", "0.3", "1e+10".
std::string plain(double value);

/// Ends the program with an exit code and one sentence.
class Failure : public std::runtime_error
{
public:
    Failure(Exit exit, const std::string &message) : std::runtime_error(message), exit_(exit) {}
    Exit exit() const { return exit_; }

    /// What the chart's report warned of before it came to this: it may be the reason.
    const std::vector<std::string> &warnings() const { return warnings_; }
    void setWarnings(std::vector<std::string> warnings) { warnings_ = std::move(warnings); }

private:
    Exit exit_;
    std::vector<std::string> warnings_;
};

}  // namespace demos
