#include "Cores.h"

#include <cstddef>
#include <cstring>
#include <string>
#include <utility>

#include <sched.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace benchmark_planners
{
namespace
{

/// A bound name in the abstract socket namespace serves as the lock: it is known machine-wide, leaves no file behind,
/// and the kernel frees it when the process ends, however it ends.
/// @return the socket; -1 if another has the name
int bindName(const std::string &name)
{
    const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (socket < 0)
        return -1;
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name.data(), name.size());  // the first byte stays 0: abstract
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    const void *generic = &address;
    if (bind(socket, static_cast<const sockaddr *>(generic), length) == 0)
        return socket;
    close(socket);
    return -1;
}

}  // namespace

std::vector<int> allowedCores()
{
    std::vector<int> cores;
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0)
        for (int core = 0; core < CPU_SETSIZE; ++core)
            if (CPU_ISSET(static_cast<std::size_t>(core), &set))
                cores.push_back(core);
    if (cores.empty())
        cores.push_back(0);
    return cores;
}

CoreLease CoreLease::take()
{
    for (const int core : allowedCores())
    {
        const int socket = bindName("seahex-benchmark-core-" + std::to_string(core));
        if (socket >= 0)
            return {core, socket};
    }
    return {-1, -1};
}

CoreLease::CoreLease(CoreLease &&other) noexcept
    : core_(std::exchange(other.core_, -1)), socket_(std::exchange(other.socket_, -1))
{
}

CoreLease &CoreLease::operator=(CoreLease &&other) noexcept
{
    std::swap(core_, other.core_);
    std::swap(socket_, other.socket_);
    return *this;
}

CoreLease::~CoreLease()
{
    if (socket_ >= 0)
        close(socket_);
}

void CoreLease::pinThisProcess() const
{
    if (!hasCore())
        return;
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(static_cast<std::size_t>(core_), &set);
    // A job that can't be pinned runs all the same; its share of the processor is in the results.
    static_cast<void>(sched_setaffinity(0, sizeof set, &set));
}

}  // namespace benchmark_planners
