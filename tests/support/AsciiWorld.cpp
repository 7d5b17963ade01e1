#include "support/AsciiWorld.h"

#include <seahex/world/CellBits.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>
#include <type_traits>

namespace seahex::test
{
namespace
{

struct Row
{
    std::size_t indent;
    std::string cells;
};

Row parseRow(const std::string &line)
{
    Row row{line.find_first_not_of(' '), {}};
    for (std::size_t i = row.indent; i < line.size(); ++i)
    {
        const bool onCell = (i - row.indent) % 2 == 0;
        if (onCell == (line[i] == ' '))
            throw std::invalid_argument("cells are one character and one space each: \"" + line + "\"");
        if (onCell)
            row.cells += line[i];
    }
    return row;
}

/// How much farther east than odd rows even ones are drawn.
template <class LatticeType>
constexpr std::size_t indentOfEvenRows = std::is_same_v<LatticeType, HexLattice> ? 1 : 0;

template <class LatticeType>
std::vector<Row> parseRows(const std::string &picture)
{
    std::vector<Row> rows;
    std::istringstream lines(picture);
    for (std::string line; std::getline(lines, line);)
    {
        line.erase(line.find_last_not_of(' ') + 1);
        if (!line.empty())
            rows.push_back(parseRow(line));
    }
    if (rows.empty())
        throw std::invalid_argument("a world needs a row");
    for (std::size_t i = 1; i < rows.size(); ++i)
    {
        if (rows[i].cells.size() != rows[0].cells.size())
            throw std::invalid_argument("the rows of a world must be of one length: " + rows[i].cells);
        if (rows[i].indent + (i % 2 == 1 ? indentOfEvenRows<LatticeType> : 0) != rows[0].indent)
            throw std::invalid_argument("a row is drawn too far to the east or west: " + rows[i].cells);
    }
    return rows;
}

}  // namespace

template <class LatticeType>
AsciiWorldOf<LatticeType>::AsciiWorldOf(const std::string &picture, double pitch, const Point &northWest)
{
    const std::vector<Row> rows = parseRows<LatticeType>(picture);
    std::vector<Cell> blocked;
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t column = 0; column < rows[row].cells.size(); ++column)
        {
            const char drawn = rows[row].cells[column];
            const Cell cell = LatticeType::cell({static_cast<std::int64_t>(column), static_cast<std::int64_t>(row)});
            if (drawn == '#')
                blocked.push_back(cell);
            else if (std::isalpha(static_cast<unsigned char>(drawn)) != 0)
                named_[drawn] = cell;
            else if (drawn != '.')
                throw std::invalid_argument(std::string("a world has no cells drawn as ") + drawn);
        }
    const LatticeType lattice(northWest, pitch, static_cast<std::int64_t>(rows[0].cells.size()),
                              static_cast<std::int64_t>(rows.size()));
    occupancy_ = occupancyWith(lattice, blocked);
}

template <class LatticeType>
std::shared_ptr<const LatticeOccupancy<LatticeType>>
occupancyWith(const LatticeType &lattice, const std::vector<typename LatticeType::Cell> &blocked)
{
    const CellLayout layout(lattice.columns(), lattice.rows());
    CellBits bits(layout);
    bits.setOutside();
    for (const auto cell : blocked)
    {
        const OffsetCoord offset = toOffset(cell);
        bits.setSpan(offset.row, offset.column, offset.column);
    }
    return std::make_shared<const LatticeOccupancy<LatticeType>>(lattice, layout, bits.words());
}

template <class LatticeType>
std::string toPicture(const LatticeOccupancy<LatticeType> &occupancy,
                      const std::vector<typename LatticeType::Cell> &path)
{
    const LatticeType &lattice = occupancy.lattice();
    std::string picture = "\n";
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
    {
        picture += std::string(row % 2 == 0 ? indentOfEvenRows<LatticeType> : 0, ' ');
        for (std::int64_t column = 0; column < lattice.columns(); ++column)
        {
            const auto cell = LatticeType::cell({column, row});
            const bool onPath = std::find(path.begin(), path.end(), cell) != path.end();
            picture += onPath ? '*' : occupancy.isBlocked(cell) ? '#' : '.';
            picture += column + 1 < lattice.columns() ? " " : "\n";
        }
    }
    return picture;
}

template class AsciiWorldOf<HexLattice>;
template class AsciiWorldOf<SquareLattice>;
template std::shared_ptr<const HexOccupancy> occupancyWith(const HexLattice &, const std::vector<HexCoord> &);
template std::shared_ptr<const SquareOccupancy> occupancyWith(const SquareLattice &, const std::vector<OffsetCoord> &);
template std::string toPicture(const HexOccupancy &, const std::vector<HexCoord> &);
template std::string toPicture(const SquareOccupancy &, const std::vector<OffsetCoord> &);

}  // namespace seahex::test
