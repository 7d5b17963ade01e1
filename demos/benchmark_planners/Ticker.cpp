#include "Ticker.h"

#include <cmath>
#include <cstdio>

#include <unistd.h>

namespace benchmark_planners
{
namespace
{

std::string minutes(double seconds)
{
    const auto whole = static_cast<long>(std::lround(seconds));
    char text[32];
    std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
    return text;
}

}  // namespace

Ticker::Ticker() : isTerminal_(isatty(STDERR_FILENO) != 0) {}

void Ticker::begin(std::size_t jobs, std::size_t doneBefore, std::size_t atATime)
{
    jobs_ = jobs;
    doneBefore_ = doneBefore;
    atATime_ = atATime;
    begin_ = Clock::now();
    if (doneBefore > 0)
        say(std::to_string(doneBefore) + " of " + std::to_string(jobs) + " jobs were done before");
}

void Ticker::tick()
{
    if (!isTerminal_ || Clock::now() - lastTick_ < std::chrono::milliseconds(200))
        return;
    lastTick_ = Clock::now();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    std::fprintf(stderr, "\r\033[K%zu of %zu jobs done, %s%s", doneBefore_ + done_, jobs_, minutes(seconds).c_str(),
                 remaining().c_str());
    std::fflush(stderr);
}

std::string Ticker::remaining() const
{
    if (done_ == 0)
        return "";
    const auto left = static_cast<double>(jobs_ - doneBefore_ - done_);
    const double seconds = left * jobSeconds_ / static_cast<double>(done_ * atATime_);
    return ", about " + minutes(seconds) + " to go";
}

void Ticker::jobDone(const JobRecord &record)
{
    ++done_;
    jobSeconds_ += record.seconds;
    for (const Crash &crash : record.crashes)
        say("pair " + std::to_string(record.pair) + ": " + crash.planner + " crashed: " + crash.how +
            (crash.said.empty() ? "" : " (" + crash.said + ")"));
    if (!isTerminal_)
        say("job " + std::to_string(doneBefore_ + done_) + " of " + std::to_string(jobs_) + " done: pair " +
            std::to_string(record.pair) + ", " + minutes(record.seconds));
}

void Ticker::say(const std::string &sentence) const
{
    std::fprintf(stderr, "%s%s\n", isTerminal_ ? "\r\033[K" : "", sentence.c_str());
    std::fflush(stderr);
}

void Ticker::end()
{
    if (!isTerminal_)
        return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
}

}  // namespace benchmark_planners
