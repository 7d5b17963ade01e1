#pragma once

#include "ResultsFolder.h"

#include <chrono>
#include <cstddef>
#include <string>

namespace benchmark_planners
{

/// Tells on standard error how far a campaign has come: on a terminal one line that renews itself, elsewhere a line a
/// job. No thread: a process that forks had better have none.
class Ticker
{
public:
    Ticker();

    void begin(std::size_t jobs, std::size_t doneBefore, std::size_t atATime);
    /// Renews the line now and then.
    void tick();
    void jobDone(const JobRecord &record);
    void say(const std::string &sentence) const;
    void end();

private:
    using Clock = std::chrono::steady_clock;

    std::string remaining() const;

    bool isTerminal_;
    std::size_t jobs_ = 0;
    std::size_t doneBefore_ = 0;
    std::size_t done_ = 0;
    std::size_t atATime_ = 1;
    double jobSeconds_ = 0.0;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point lastTick_;
};

}  // namespace benchmark_planners
