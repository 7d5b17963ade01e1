#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace seahex::test
{

/// How a program ended, and what it said.
struct ProgramResult
{
    int exitCode = -1;  ///< -1 if it did not end by itself
    int signal = 0;     ///< the signal that ended it (a crash); 0 if none did
    bool timedOut = false;
    std::string out;  ///< standard output
    std::string err;  ///< standard error

    /// For messages of tests: code or signal, and both texts.
    std::string summary() const;
};

/// Runs a program and waits for it. No shell is between: every argument arrives as it is, blanks, quotes and NaN
/// included. Standard input is empty. A program that runs longer than the limit is killed.
/// @param command        path of the program, then its arguments
/// @param workingFolder  where it runs; here if empty
/// @throws std::runtime_error if it can't be started at all
ProgramResult runProgram(const std::vector<std::string> &command, const std::filesystem::path &workingFolder = {},
                         std::chrono::seconds limit = std::chrono::seconds(120));

}  // namespace seahex::test
