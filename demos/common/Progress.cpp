#include "Progress.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace demos
{

Progress::Progress() : isTerminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress()
{
    end();
}

void Progress::stage(const std::string &what)
{
    end();
    if (!isTerminal_)
        return;
    running_ = true;
    ticker_ = std::thread(
        [this, what]
        {
            const auto begin = std::chrono::steady_clock::now();
            while (running_)
            {
                const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
                std::fprintf(stderr, "\r\033[K%s ... %.1f s", what.c_str(), seconds);
                std::fflush(stderr);
                for (int i = 0; i < 10 && running_; ++i)
                    std::this_thread::sleep_for(std::chrono::milliseconds(10));
            }
            std::fprintf(stderr, "\r\033[K");
            std::fflush(stderr);
        });
}

void Progress::end()
{
    running_ = false;
    if (ticker_.joinable())
        ticker_.join();
}

}  // namespace demos
