#pragma once

#include <seahex/geometry/HexLattice.h>
#include <seahex/world/Occupancy.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace seahex::test
{

/// A small world drawn with characters, north up, one character and one space a cell:
///
///     AsciiWorld world(R"(
///          A . # .
///         . . # .
///          . . . B
///     )");
///
/// '.' is free, '#' blocked, and a letter free and named. Even rows (the first one is row 0) are drawn one character
/// farther to the east than odd ones, as they lie.
class AsciiWorld
{
public:
    /// @throws std::invalid_argument if the picture is not as said above, or its rows differ in length
    explicit AsciiWorld(const std::string &picture, double pitch = 1.0, const Point &northWest = Point::Zero());

    const HexLattice &lattice() const { return occupancy_->lattice(); }
    const HexOccupancy &occupancy() const { return *occupancy_; }
    std::shared_ptr<const HexOccupancy> shared() const { return occupancy_; }

    /// The cell drawn as this letter. @throws std::out_of_range if there is none
    HexCoord cell(char letter) const { return named_.at(letter); }
    Point centre(char letter) const { return lattice().centre(cell(letter)); }

private:
    std::shared_ptr<const HexOccupancy> occupancy_;
    std::map<char, HexCoord> named_;
};

/// The occupancy of a lattice in which these cells, and no others of the rectangle, are blocked.
std::shared_ptr<const HexOccupancy> occupancyWith(const HexLattice &lattice, const std::vector<HexCoord> &blocked);
std::shared_ptr<const SquareOccupancy> occupancyWith(const SquareLattice &lattice,
                                                     const std::vector<OffsetCoord> &blocked);

/// The picture of an occupancy, the cells of `path` drawn as '*': for failures, and to compare with an expected
/// picture. Rows of squares are drawn without the shift.
std::string toPicture(const Occupancy &occupancy, const std::vector<OffsetCoord> &path);
std::string toPicture(const HexOccupancy &occupancy, const std::vector<HexCoord> &path = {});

}  // namespace seahex::test
