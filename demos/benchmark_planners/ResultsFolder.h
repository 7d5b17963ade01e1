#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace benchmark_planners
{

/// A planner that ended its process.
struct Crash
{
    std::string planner;
    std::string how;   ///< "Aborted", "Segmentation fault", "did not stop in time", ...
    std::string said;  ///< its last words on standard error
};

/// What has come of a pair.
struct JobRecord
{
    unsigned pair = 0;
    std::vector<std::string> logs;  ///< file names; one, or one a planner where the pair had to be run again
    std::vector<Crash> crashes;
    double seconds = 0.0;
};

/// The folder of a campaign: manifest.json with its settings, a log (or several) and a record a pair. Every file in it
/// appears whole, so several processes, on several machines, may work on it.
class ResultsFolder
{
public:
    /// Makes the folder if need be.
    /// @throws demos::Failure (Exit::Usage) if that is not possible
    explicit ResultsFolder(std::filesystem::path folder);

    /// Makes the folder the campaign's of these settings.
    /// @throws demos::Failure (Exit::Usage) if it is already that of others; names the first that differs
    void claim(const nlohmann::ordered_json &manifest) const;

    /// True if the pair's record and all the logs that it names are there.
    bool isDone(unsigned pair) const;
    void write(const JobRecord &record) const;

    std::filesystem::path log(unsigned pair) const;
    /// Of one planner, where the pair is run a process a planner.
    std::filesystem::path log(unsigned pair, const std::string &planner) const;
    const std::filesystem::path &path() const { return folder_; }

private:
    std::filesystem::path record(unsigned pair) const;

    std::filesystem::path folder_;
};

}  // namespace benchmark_planners
