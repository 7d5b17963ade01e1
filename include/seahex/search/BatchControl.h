#pragma once

#include <cstddef>
#include <functional>

namespace seahex
{

/// How a batch of searches is run.
struct BatchControl
{
    /// At most so many at once; 0: as many as the machine runs at once. Each takes the memory of a search.
    unsigned int threads = 0;
    /// If it returns true, all searches end soon. Any thread asks, several at once perhaps. Empty: none ends early.
    std::function<bool()> stop;
    /// Told how many searches are done, one more each time; by any thread, but one at a time.
    std::function<void(std::size_t done)> progress;
};

}  // namespace seahex
