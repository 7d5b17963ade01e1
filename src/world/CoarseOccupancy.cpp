#include "seahex/world/CoarseOccupancy.h"

#include <algorithm>
#include <cmath>

namespace seahex
{
namespace
{

/// The fine cells of one row that touch a large cell, relative to the fine cell in its middle.
struct Span
{
    std::int64_t s;
    std::int64_t firstQ;
    std::int64_t lastQ;
};

std::int64_t floorHalf(std::int64_t value)
{
    return (value - (value & 1)) / 2;
}

std::vector<Span> touching(std::int64_t factor)
{
    const std::int64_t most = factor + 1;
    std::vector<Span> spans;
    for (std::int64_t s = -most; s <= most; ++s)
    {
        // |q - r| = |2 q + s|, |r - s| = |q + 2 s|, |s - q|
        const std::int64_t first = std::max({floorHalf(-most - s + 1), -most - 2 * s, s - most});
        const std::int64_t last = std::min({floorHalf(most - s), most - 2 * s, s + most});
        if (first <= last)
            spans.push_back({s, first, last});
    }
    return spans;
}

/// Is any of the bits from first to last set?
bool anySet(const CellWords &words, CellIndex first, CellIndex last)
{
    const std::uint64_t head = ~std::uint64_t{0} << (first & 63);
    const std::uint64_t tail = ~std::uint64_t{0} >> (63 - (last & 63));
    std::size_t word = first >> 6;
    const std::size_t lastWord = last >> 6;
    if (word == lastWord)
        return (words[word] & head & tail) != 0;
    if ((words[word] & head) != 0)
        return true;
    while (++word < lastWord)
        if (words[word] != 0)
            return true;
    return (words[lastWord] & tail) != 0;
}

/// The lattice of large cells whose cell (0, 0) has its centre in that of the fine (0, 0), as far as the fine one
/// reaches.
HexLattice largeLattice(const HexLattice &fine, std::int64_t factor)
{
    const auto scale = static_cast<double>(factor);
    const Point origin = fine.centre({0, 0});
    return HexLattice(Point(origin.x() - scale * fine.pitch(), origin.y() + scale * fine.side()), scale * fine.pitch(),
                      fine.columns() / factor + 1, fine.rows() / factor + 1);
}

}  // namespace

CoarseOccupancy::CoarseOccupancy(const Occupancy &fine, std::int64_t factor) : factor_(factor)
{
    const HexLattice &small = *fine.lattice().hexagons();
    const HexLattice large = largeLattice(small, factor);
    const CellLayout layout(large.columns(), large.rows());
    const std::vector<Span> spans = touching(factor);
    std::vector<std::uint64_t> words(layout.wordCount(), ~std::uint64_t{0});
    const auto isFree = [&](HexCoord cell)
    {
        const HexCoord middle = factor * cell;
        for (const Span &span : spans)
        {
            const OffsetCoord first = toOffset(HexCoord{middle.q + span.firstQ, middle.s + span.s});
            const std::int64_t last = first.column + span.lastQ - span.firstQ;
            if (first.row < 0 || first.row >= small.rows() || first.column < 0 || last >= small.columns() ||
                anySet(fine.words(), fine.layout().index(first), fine.layout().index(OffsetCoord{last, first.row})))
                return false;
        }
        return true;
    };
    for (std::int64_t row = 0; row < large.rows(); ++row)
        for (std::int64_t column = 0; column < large.columns(); ++column)
            if (isFree(toCube({column, row})))
            {
                const CellIndex index = layout.index(OffsetCoord{column, row});
                words[index >> 6] &= ~(std::uint64_t{1} << (index & 63));
            }
    cells_ = std::make_shared<const HexOccupancy>(large, layout, std::move(words));
}

HexCoord CoarseOccupancy::holding(HexCoord fine) const
{
    // the nearest of the triangular lattice's points: round all three coordinates, mend the one that was rounded most
    const auto scaled = [this](std::int64_t coordinate)
    {
        return static_cast<double>(coordinate) / static_cast<double>(factor_);
    };
    const double q = scaled(fine.q);
    const double s = scaled(fine.s);
    const double r = scaled(fine.r());
    double wholeQ = std::round(q);
    double wholeS = std::round(s);
    const double wholeR = std::round(r);
    const double offQ = std::abs(q - wholeQ);
    const double offS = std::abs(s - wholeS);
    const double offR = std::abs(r - wholeR);
    if (offQ > offS && offQ > offR)
        wholeQ = -wholeS - wholeR;
    else if (offS > offR)
        wholeS = -wholeQ - wholeR;
    return {static_cast<std::int64_t>(wholeQ), static_cast<std::int64_t>(wholeS)};
}

std::vector<std::shared_ptr<const CoarseOccupancy>> coarseOccupancies(const Occupancy &fine)
{
    constexpr std::int64_t fewCells = 4000;
    constexpr std::int64_t manyCells = 80000;
    std::vector<std::shared_ptr<const CoarseOccupancy>> levels;
    for (std::int64_t factor = 4; fine.lattice().cellCount() / (factor * factor) >= fewCells; factor *= 2)
        if (fine.lattice().cellCount() / (factor * factor) <= manyCells)
            levels.push_back(std::make_shared<const CoarseOccupancy>(fine, factor));
    return levels;
}

}  // namespace seahex
