#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace seahex::test
{

/// Which rules were broken, how often, and how for the first time.
class ConformanceReport
{
public:
    void broken(const std::string &rule, const std::string &how)
    {
        ++broken_.try_emplace(rule, 0, how).first->second.first;
    }

    /// One line a rule: "rule: how (so many times)".
    std::vector<std::string> failures() const
    {
        std::vector<std::string> lines;
        for (const auto &[rule, record] : broken_)
            lines.push_back(rule + ": " + record.second + " (" + std::to_string(record.first) + " times)");
        return lines;
    }

private:
    std::map<std::string, std::pair<int, std::string>> broken_;
};

}  // namespace seahex::test
