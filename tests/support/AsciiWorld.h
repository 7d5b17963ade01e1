#pragma once

#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/SquareLattice.h>
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
/// '.' is free, '#' blocked, and a letter free and named. Even rows of hexagons (the first one is row 0) are drawn one
/// character farther to the east than odd ones, as they lie; all rows of a SquareWorld begin at one place.
template <class LatticeType>
class AsciiWorldOf
{
public:
    using Cell = typename LatticeType::Cell;

    /// @throws std::invalid_argument if the picture is not as said above, or its rows differ in length
    explicit AsciiWorldOf(const std::string &picture, double pitch = 1.0, const Point &northWest = Point::Zero());

    const LatticeType &lattice() const { return occupancy_->lattice(); }
    const LatticeOccupancy<LatticeType> &occupancy() const { return *occupancy_; }
    std::shared_ptr<const LatticeOccupancy<LatticeType>> shared() const { return occupancy_; }

    /// The cell drawn as this letter. @throws std::out_of_range if there is none
    Cell cell(char letter) const { return named_.at(letter); }
    Point centre(char letter) const { return lattice().centre(cell(letter)); }

private:
    std::shared_ptr<const LatticeOccupancy<LatticeType>> occupancy_;
    std::map<char, Cell> named_;
};

using AsciiWorld = AsciiWorldOf<HexLattice>;
using SquareWorld = AsciiWorldOf<SquareLattice>;

/// The occupancy of a lattice in which these cells, and no others of the rectangle, are blocked.
template <class LatticeType>
std::shared_ptr<const LatticeOccupancy<LatticeType>>
occupancyWith(const LatticeType &lattice, const std::vector<typename LatticeType::Cell> &blocked);

/// The picture of an occupancy, the cells of `path` drawn as '*': for failures, and to compare with an expected
/// picture.
template <class LatticeType>
std::string toPicture(const LatticeOccupancy<LatticeType> &occupancy,
                      const std::vector<typename LatticeType::Cell> &path = {});

}  // namespace seahex::test
