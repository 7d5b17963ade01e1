#pragma once

#include <atomic>
#include <string>
#include <thread>

namespace demos
{

/// One line on a terminal's standard error that says what is going on and for how long; nothing where standard error is
/// no terminal. Wiped when the next stage begins and at the end.
class Progress
{
public:
    Progress();
    ~Progress();
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;

    /// Begins a stage: "reading the chart".
    void stage(const std::string &what);
    void end();

private:
    bool isTerminal_;
    std::atomic<bool> running_{false};
    std::thread ticker_;
};

}  // namespace demos
