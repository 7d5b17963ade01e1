#pragma once

#include "seahex/search/BatchControl.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace seahex
{

/// Threads that take numbered pieces of work from one counter until none is left.
class WorkTeam
{
public:
    explicit WorkTeam(const BatchControl &control) : control_(control) {}

    /// Each thread makes a worker of its own, makeWorker(stop), and calls worker(k) for one k below `count` after the
    /// other; it returns false if it was stopped. The caller's thread works too. Returns when all have ended.
    /// @throws what a worker threw first; the others are told to stop then
    template <class MakeWorker>
    void run(std::size_t count, const MakeWorker &makeWorker)
    {
        const auto work = [&]
        {
            try
            {
                auto worker = makeWorker([this] { return isStopped(); });
                for (std::size_t k; !isStopped() && (k = next_.fetch_add(1)) < count;)
                    if (worker(k))
                        tellProgress();
            }
            catch (...)
            {
                const std::lock_guard<std::mutex> lock(mutex_);
                if (!failure_)
                    failure_ = std::current_exception();
                isOver_ = true;
            }
        };
        std::vector<std::thread> helpers;
        try
        {
            helpers.reserve(threadCount(count) - 1);
            while (helpers.size() < threadCount(count) - 1)
                helpers.emplace_back(work);
        }
        catch (const std::exception &)
        {
            // no more threads, or no memory for them, to be had: those there are do it
        }
        work();
        for (std::thread &helper : helpers)
            helper.join();
        if (failure_)
            std::rethrow_exception(failure_);
    }

private:
    std::size_t threadCount(std::size_t count) const
    {
        const std::size_t wanted = control_.threads != 0 ? control_.threads : std::thread::hardware_concurrency();
        return std::max<std::size_t>(1, std::min(wanted, count));
    }

    bool isStopped()
    {
        if (!isOver_ && control_.stop && control_.stop())
            isOver_ = true;
        return isOver_;
    }

    void tellProgress()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ++done_;
        if (control_.progress)
            control_.progress(done_);
    }

    const BatchControl &control_;
    std::atomic<std::size_t> next_{0};
    std::atomic<bool> isOver_{false};
    std::mutex mutex_;
    std::size_t done_ = 0;
    std::exception_ptr failure_;
};

}  // namespace seahex
