#pragma once

#include <functional>
#include <string>

namespace demos
{

/// Runs a program's work and ends it as all of this folder end: a Failure, lack of memory and every other exception
/// become one sentence on standard error, or one JSON object on standard output if --json is among the arguments.
/// @return the exit code
int runProgram(const std::string &name, int argc, const char *const *argv, const std::function<void()> &work);

/// Prints to standard output.
/// @throws Failure if it can't be written: a result that nobody gets is none
void print(const std::string &text);

}  // namespace demos
