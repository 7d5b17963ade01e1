#include "ResultsFolder.h"

#include "common/Failure.h"
#include "common/WholeFile.h"

#include <cstdio>
#include <system_error>

namespace benchmark_planners
{
namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string pairName(unsigned pair)
{
    char name[32];
    std::snprintf(name, sizeof name, "pair-%04u", pair);
    return name;
}

/// The first value in which two documents differ, by its path, and how.
std::string firstDifference(const Json &there, const Json &here, const std::string &path)
{
    if (there.is_object() && here.is_object())
        for (const auto &[key, value] : here.items())
            if (there.value(key, Json()) != value)
                return firstDifference(there.value(key, Json()), value,
                                       path.empty() ? key : std::string(path).append(".").append(key));
    const auto brief = [](const Json &value)
    {
        constexpr std::size_t most = 100;
        const std::string text = value.dump();
        return text.size() > most ? text.substr(0, most) + "..." : text;
    };
    return (path.empty() ? "manifest.json" : path) + " is " + brief(there) + " there and " + brief(here) + " here";
}

}  // namespace

ResultsFolder::ResultsFolder(fs::path folder) : folder_(std::move(folder))
{
    std::error_code error;
    fs::create_directories(folder_, error);
    if (!fs::is_directory(folder_, error))
        throw demos::Failure(demos::Exit::Usage, "--out: can't make the folder " + folder_.string());
}

void ResultsFolder::claim(const Json &manifest) const
{
    const fs::path file = folder_ / "manifest.json";
    demos::writeWholeIfAbsent(file, manifest.dump(2) + "\n");
    const Json there = Json::parse(demos::readWhole(file), nullptr, false);
    if (there != manifest)
        throw demos::Failure(demos::Exit::Usage,
                             "the folder " + folder_.string() +
                                 " holds the results of other settings: " + firstDifference(there, manifest, "") +
                                 "; choose another --out, or give the same settings");
}

bool ResultsFolder::isDone(unsigned pair) const
{
    std::error_code ignored;
    if (!fs::exists(record(pair), ignored))
        return false;
    const Json there = Json::parse(demos::readWhole(record(pair)), nullptr, false);
    if (!there.is_object() || !there.contains("logs"))
        return false;
    for (const Json &log : there.at("logs"))
        if (!fs::exists(folder_ / log.get<std::string>(), ignored))
            return false;
    return true;
}

void ResultsFolder::write(const JobRecord &job) const
{
    Json crashes = Json::array();
    for (const Crash &crash : job.crashes)
        crashes.push_back({{"planner", crash.planner}, {"how", crash.how}, {"said", crash.said}});
    const Json document = {{"pair", job.pair}, {"seconds", job.seconds}, {"logs", job.logs}, {"crashed", crashes}};
    demos::writeWhole(record(job.pair), document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

fs::path ResultsFolder::log(unsigned pair) const
{
    return folder_ / (pairName(pair) + ".log");
}

fs::path ResultsFolder::log(unsigned pair, const std::string &planner) const
{
    return folder_ / (pairName(pair) + "-" + planner + ".log");
}

fs::path ResultsFolder::record(unsigned pair) const
{
    return folder_ / (pairName(pair) + ".json");
}

}  // namespace benchmark_planners
