#include "support/MovingAiMap.h"

#include "support/AsciiWorld.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace seahex::test
{
namespace
{

/// Lines of a text with their numbers, for errors that say where.
class Lines
{
public:
    Lines(std::istream &in, std::string name) : in_(in), name_(std::move(name)) {}

    /// Reads the next line, without the end of line of any system. @return false at the end
    bool next()
    {
        if (!std::getline(in_, line_))
            return false;
        ++number_;
        if (!line_.empty() && line_.back() == '\r')
            line_.pop_back();
        return true;
    }

    const std::string &line() const { return line_; }
    bool isBlank() const { return line_.find_first_not_of(" \t") == std::string::npos; }

    [[noreturn]] void fail(const std::string &what) const
    {
        throw std::runtime_error(name_ + ":" + std::to_string(number_) + ": " + what);
    }

    void need(const std::string &what)
    {
        if (!next())
        {
            ++number_;
            fail("the file ends where " + what + " should be");
        }
    }

private:
    std::istream &in_;
    std::string name_;
    std::string line_;
    int number_ = 0;
};

std::ifstream open(const std::filesystem::path &path)
{
    std::ifstream in(path);
    if (!in)
        throw std::runtime_error(path.string() + ": can't be read");
    return in;
}

bool isTerrainPassable(char terrain, const Lines &lines)
{
    constexpr std::string_view passable = ".GS";
    constexpr std::string_view blocked = "@OTW";
    if (passable.find(terrain) == std::string_view::npos && blocked.find(terrain) == std::string_view::npos)
        lines.fail(std::string("'") + terrain + "' is no terrain");
    return passable.find(terrain) != std::string_view::npos;
}

/// The number after a keyword of the header.
std::int64_t readSize(Lines &lines, const std::string &keyword)
{
    lines.need("'" + keyword + "'");
    std::istringstream words(lines.line());
    std::string word;
    std::int64_t size = 0;
    if (!(words >> word >> size) || word != keyword || size <= 0 || size > 1 << 20 || words >> word)
        lines.fail("'" + keyword + "' and a positive number expected, not '" + lines.line() + "'");
    return size;
}

MovingAiScenario readScenario(const Lines &lines, const MovingAiMap &map)
{
    std::istringstream words(lines.line());
    int bucket = 0;
    std::string name;
    std::int64_t columns = 0;
    std::int64_t rows = 0;
    MovingAiScenario scenario{};
    std::string rest;
    if (!(words >> bucket >> name >> columns >> rows >> scenario.start.column >> scenario.start.row >>
          scenario.goal.column >> scenario.goal.row >> scenario.optimalLength) ||
        words >> rest)
        lines.fail("bucket, map, width, height, start x and y, goal x and y, optimal length expected");
    if (columns != map.columns() || rows != map.rows())
        lines.fail("the scenario is for a map of " + std::to_string(columns) + " x " + std::to_string(rows) +
                   " cells, this one has " + std::to_string(map.columns()) + " x " + std::to_string(map.rows()));
    if (!map.isPassable(scenario.start) || !map.isPassable(scenario.goal))
        lines.fail(std::string(map.isPassable(scenario.start) ? "the goal" : "the start") + " is no passable cell");
    if (!std::isfinite(scenario.optimalLength) || scenario.optimalLength < 0.0)
        lines.fail("the optimal length is no length");
    return scenario;
}

}  // namespace

MovingAiMap::MovingAiMap(std::int64_t columns, std::int64_t rows, std::vector<bool> passable)
    : columns_(columns), rows_(rows), passable_(std::move(passable))
{
}

MovingAiMap MovingAiMap::read(const std::filesystem::path &path)
{
    std::ifstream in = open(path);
    return read(in, path.string());
}

MovingAiMap MovingAiMap::read(std::istream &in, const std::string &name)
{
    Lines lines(in, name);
    lines.need("'type octile'");
    if (lines.line() != "type octile")
        lines.fail("'type octile' expected, not '" + lines.line() + "'");
    const std::int64_t rows = readSize(lines, "height");
    const std::int64_t columns = readSize(lines, "width");
    lines.need("'map'");
    if (lines.line() != "map")
        lines.fail("'map' expected, not '" + lines.line() + "'");
    std::vector<bool> passable;
    for (std::int64_t row = 0; row < rows; ++row)
    {
        lines.need("row " + std::to_string(row) + " of the map");
        if (static_cast<std::int64_t>(lines.line().size()) != columns)
            lines.fail(std::to_string(columns) + " cells expected, not " + std::to_string(lines.line().size()));
        for (const char terrain : lines.line())
            passable.push_back(isTerrainPassable(terrain, lines));
    }
    while (lines.next())
        if (!lines.isBlank())
            lines.fail("the map has more than " + std::to_string(rows) + " rows");
    return {columns, rows, std::move(passable)};
}

std::shared_ptr<const SquareOccupancy> MovingAiMap::occupancy() const
{
    std::vector<OffsetCoord> blocked;
    for (std::int64_t row = 0; row < rows_; ++row)
        for (std::int64_t column = 0; column < columns_; ++column)
            if (!isPassable({column, row}))
                blocked.push_back({column, row});
    return occupancyWith(SquareLattice(Point::Zero(), 1.0, columns_, rows_), blocked);
}

std::vector<MovingAiScenario> readMovingAiScenarios(const std::filesystem::path &path, const MovingAiMap &map)
{
    std::ifstream in = open(path);
    return readMovingAiScenarios(in, path.string(), map);
}

std::vector<MovingAiScenario> readMovingAiScenarios(std::istream &in, const std::string &name, const MovingAiMap &map)
{
    Lines lines(in, name);
    lines.need("'version 1'");
    std::istringstream words(lines.line());
    std::string keyword;
    double version = 0.0;
    if (!(words >> keyword >> version) || keyword != "version" || version != 1.0)
        lines.fail("'version 1' expected, not '" + lines.line() + "'");
    std::vector<MovingAiScenario> scenarios;
    while (lines.next())
        if (!lines.isBlank())
            scenarios.push_back(readScenario(lines, map));
    return scenarios;
}

std::vector<std::filesystem::path> movingAiMapsIn(const std::filesystem::path &folder)
{
    std::vector<std::filesystem::path> maps;
    for (const auto &entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".map")
            maps.push_back(entry.path());
    std::sort(maps.begin(), maps.end());
    return maps;
}

std::filesystem::path scenariosOf(const std::filesystem::path &map)
{
    return map.string() + ".scen";
}

}  // namespace seahex::test
