#pragma once

#include "seahex/geometry/Lattice.h"
#include "seahex/io/PictureFrame.h"

#include <boost/container/static_vector.hpp>

#include <cstdint>

namespace seahex
{

/// A corner of cells, by whole numbers: x in half pitches, y in quarters of a cell's height, from the lattice's
/// north-west corner to the south-east. So cells that meet at a corner have the very same one.
struct CellCorner
{
    std::int64_t x = 0;
    std::int64_t y = 0;
};

/// The corners of one cell.
using CellCorners = boost::container::static_vector<CellCorner, 6>;

/// The corners of a cell, clockwise as seen with north up: of a hexagon from its northern tip, of a square from its
/// north-west corner.
CellCorners cornersOf(const Lattice &lattice, OffsetCoord cell);

/// The cell that shares the edge from corner `edge` of cornersOf() to the next one.
OffsetCoord cellBeyond(const Lattice &lattice, OffsetCoord cell, std::size_t edge);

Point toPlane(const Lattice &lattice, CellCorner corner);

/// The corner on the page, to an eighth of a pixel: far below what is seen, and few digits in an SVG.
Point toPage(const PictureFrame &frame, const Lattice &lattice, CellCorner corner);

}  // namespace seahex
