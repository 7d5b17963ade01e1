#pragma once

#include <seahex/geometry/HexCoord.h>
#include <seahex/search/SearchMemory.h>
#include <seahex/world/Occupancy.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace seahex::contest
{

/// From one free cell to another.
struct Query
{
    HexCoord start;
    HexCoord goal;
};

struct Answer
{
    double cost = std::numeric_limits<double>::infinity();  ///< Euclidean length of the best chain of jumps, in
                                                            ///< pitches; infinite if there is none
    std::uint64_t expanded = 0;                             ///< cells
    std::uint64_t touched = 0;                              ///< cells that got a cost
    SearchMemory memory;                                    ///< after the query; zeros where it cannot tell
};

/// A search on one occupancy. What it makes for the whole lattice once is made by its constructor; a query then
/// includes all that it has to do for it: resetting what the query before left, and reading out the path.
class Contender
{
public:
    virtual ~Contender() = default;
    virtual Answer solve(const Query &query) = 0;
};

enum class Side
{
    Ours,
    Peer  ///< what ours is held against
};

/// How to make a contender, and what for.
struct ContenderKind
{
    std::string name;
    Side side = Side::Ours;
    int rings = 1;               ///< 1, 2 or 3: the jumps that it makes, and so the costs that it must find
    std::int64_t mostCells = 0;  ///< larger worlds would take it too long, or too much memory
    std::function<std::unique_ptr<Contender>(const HexOccupancy &)> make;
};

/// All that take part, a line each; the textbook ones first.
const std::vector<ContenderKind> &contenders();

/// The one of that name. @throws std::runtime_error if there is none
const ContenderKind &contenderNamed(const std::string &name);

}  // namespace seahex::contest
