#pragma once

#include <vector>

namespace benchmark_planners
{

/// The processor cores that this process may run on.
std::vector<int> allowedCores();

/// A core that one job of one process on this machine has to itself, as far as this program is concerned: as long as
/// the lease lasts no other lease on the core is given, to other processes neither. It ends with the process at the
/// latest.
class CoreLease
{
public:
    /// Takes one of the cores that this process may run on.
    /// @return a lease without a core if all are taken
    static CoreLease take();

    CoreLease(CoreLease &&other) noexcept;
    CoreLease &operator=(CoreLease &&other) noexcept;
    ~CoreLease();

    bool hasCore() const { return core_ >= 0; }
    /// Its number; negative where there is none.
    int core() const { return core_; }

    /// Moves the calling process onto the core; nothing where there is none.
    void pinThisProcess() const;

private:
    CoreLease(int core, int socket) : core_(core), socket_(socket) {}

    int core_;
    int socket_;
};

}  // namespace benchmark_planners
