#include "contest/Options.h"

#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace seahex::contest
{
namespace
{

std::uint64_t countFrom(const std::string &argument, const std::string &text)
{
    char *end = nullptr;
    const std::uint64_t count = std::strtoull(text.c_str(), &end, 10);
    if (count == 0 || *end != '\0' || text.front() == '-')
        throw std::runtime_error(argument + ": a positive number is wanted");
    return count;
}

double secondsFrom(const std::string &argument, const std::string &text)
{
    char *end = nullptr;
    const double seconds = std::strtod(text.c_str(), &end);
    if (!(seconds > 0.0 && seconds < 1e6) || *end != '\0')
        throw std::runtime_error(argument + ": a time in seconds is wanted");
    return seconds;
}

std::vector<std::string> listFrom(const std::string &text)
{
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');)
        parts.push_back(part);
    return parts;
}

}  // namespace

Options readOptions(const std::vector<std::string> &arguments)
{
    Options options;
    for (const std::string &argument : arguments)
    {
        const std::size_t equals = argument.find('=');
        const std::string name = argument.substr(0, equals);
        const std::string value = equals == std::string::npos ? "" : argument.substr(equals + 1);
        if (name == "--worlds" && !value.empty())
            options.worlds = listFrom(value);
        else if (name == "--figures" && !value.empty())
            options.figures.push_back(value);
        else if (name == "--queries")
            options.queries = countFrom(argument, value);
        else if (name == "--passes")
            options.passes = static_cast<std::int64_t>(countFrom(argument, value));
        else if (name == "--runs")
            options.runs = countFrom(argument, value);
        else if (name == "--limit")
            options.limitS = secondsFrom(argument, value);
        else if (name == "--seed")
            options.seed = countFrom(argument, value);
        else
            throw std::runtime_error(argument +
                                     " is no option; there are --worlds=S,P,N,N100,archipelago:CELLS, --queries, "
                                     "--passes, --seed, --runs, --limit, --figures and those of Google Benchmark");
    }
    return options;
}

}  // namespace seahex::contest
