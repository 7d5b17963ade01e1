#pragma once

#include <seahex/geometry/OffsetCoord.h>
#include <seahex/world/Occupancy.h>

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>
#include <vector>

namespace seahex::test
{

/// A grid map of the MovingAI benchmark (https://movingai.com/benchmarks/formats.html): squares, row 0 at the top.
///
/// '.', 'G' (ground) and 'S' (swamp) are passable; '@', 'O' (out of bounds), 'T' (trees) and 'W' (water) are not: water
/// can be entered from water only, and no scenario begins there.
class MovingAiMap
{
public:
    /// @throws std::runtime_error that names file and line if this is no such map
    static MovingAiMap read(const std::filesystem::path &path);
    /// The same from a stream, `name` in the place of the file's.
    static MovingAiMap read(std::istream &in, const std::string &name);

    std::int64_t columns() const { return columns_; }
    std::int64_t rows() const { return rows_; }
    bool contains(OffsetCoord cell) const
    {
        return cell.row >= 0 && cell.row < rows_ && cell.column >= 0 && cell.column < columns_;
    }
    /// False outside the map.
    bool isPassable(OffsetCoord cell) const
    {
        return contains(cell) && passable_[static_cast<std::size_t>(cell.row * columns_ + cell.column)];
    }

    /// The impassable cells as blocked ones, in squares of pitch 1.
    std::shared_ptr<const SquareOccupancy> occupancy() const;

private:
    MovingAiMap(std::int64_t columns, std::int64_t rows, std::vector<bool> passable);

    std::int64_t columns_;
    std::int64_t rows_;
    std::vector<bool> passable_;  // row by row
};

/// One problem of a scenario file and the length of its best path: steps to 8 neighbours, diagonal ones cost the root
/// of 2 and need both cells beside them passable. Files round it to two or more digits.
struct MovingAiScenario
{
    OffsetCoord start;
    OffsetCoord goal;
    double optimalLength;
};

/// The scenarios of one map.
/// @throws std::runtime_error that names file and line if this is no such file, a scenario is for a map of another size
/// (the format scales those; not done here), or start or goal can't be entered
std::vector<MovingAiScenario> readMovingAiScenarios(const std::filesystem::path &path, const MovingAiMap &map);
/// The same from a stream, `name` in the place of the file's.
std::vector<MovingAiScenario> readMovingAiScenarios(std::istream &in, const std::string &name, const MovingAiMap &map);

/// The maps of a folder, in alphabetical order.
std::vector<std::filesystem::path> movingAiMapsIn(const std::filesystem::path &folder);
/// The file with the scenarios of a map, beside it.
std::filesystem::path scenariosOf(const std::filesystem::path &map);

}  // namespace seahex::test
