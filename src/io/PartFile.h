#pragma once

#include <stdexcept>
#include <string>

namespace seahex
{

/// A new file beside a target, which takes the target's name when it is complete, or vanishes: nothing half-written is
/// ever seen. A symbolic link is followed: what it points to is replaced. Anything but a regular file (a device, a
/// folder) is refused.
class PartFile
{
public:
    /// The reason why the target can't be written, in the system's words.
    class Failure : public std::runtime_error
    {
    public:
        using std::runtime_error::runtime_error;
    };

    /// @throws Failure if no file can be made there
    explicit PartFile(const std::string &target);
    ~PartFile();
    PartFile(const PartFile &) = delete;
    PartFile &operator=(const PartFile &) = delete;

    /// The path to write to; there is no file yet.
    const std::string &name() const { return name_; }

    /// @throws Failure
    void takePlace() const;

private:
    std::string target_;
    std::string name_;
};

}  // namespace seahex
