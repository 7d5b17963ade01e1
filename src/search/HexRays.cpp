#include "seahex/search/HexRays.h"

#include <algorithm>

namespace seahex
{
namespace
{

constexpr std::int64_t margin = 2;  // of blocked cells, lines and positions, around what may be addressed
constexpr std::uint64_t allBlocked = ~std::uint64_t{0};

/// Rows of the occupancy, read 64 cells at a time from any column on; what lies outside is blocked.
class Rows
{
public:
    explicit Rows(const Occupancy &occupancy)
        : layout_(occupancy.layout()), words_(occupancy.words().data()), rowWords_(layout_.stride() / 64)
    {
    }

    std::uint64_t from(std::int64_t column, std::int64_t row) const
    {
        if (row < 0 || row >= layout_.rows())
            return allBlocked;
        const std::int64_t first = column + CellLayout::frame;
        const std::uint64_t *words = words_ + (row + CellLayout::frame) * rowWords_;
        const auto word = [&](std::int64_t w)
        {
            return w < 0 || w >= rowWords_ ? allBlocked : words[w];
        };
        const std::int64_t w = first >> 6;
        const auto shift = static_cast<unsigned int>(first & 63);
        return shift == 0 ? word(w) : word(w) >> shift | word(w + 1) << (64 - shift);
    }

private:
    CellLayout layout_;
    const std::uint64_t *words_;
    std::int64_t rowWords_;
};

/// Bit i of word k becomes bit k of word i ([Warren2012] 7-3).
void transpose(std::array<std::uint64_t, 64> &m)
{
    std::uint64_t mask = 0x00000000FFFFFFFF;
    for (std::size_t j = 32; j != 0; j >>= 1, mask ^= mask << j)
        for (std::size_t k = 0; k < 64; k = (k + j + 1) & ~j)
        {
            const std::uint64_t swapped = (m[k] >> j ^ m[k + j]) & mask;
            m[k] ^= swapped << j;
            m[k + j] ^= swapped;
        }
}

/// Column of the cell with this q in a row, or of this q less than 0; rows may lie outside.
std::int64_t columnOf(std::int64_t q, std::int64_t s)
{
    return toOffset(HexCoord{q, s}).column;
}

/// 64 bits of a line of words from a position on that is at most one before or behind `word`'s first.
template <class Pair>
std::uint64_t shifted(const Pair *line, std::int64_t lineWords, std::int64_t word, int by)
{
    const std::uint64_t here = line[word].blocked;
    if (by == 0)
        return here;
    if (by > 0)
        return here >> 1 | (word + 1 < lineWords ? line[word + 1].blocked : allBlocked) << 63;
    return here << 1 | (word > 0 ? line[word - 1].blocked : allBlocked) >> 63;
}

}  // namespace

HexRays::HexRays(const Occupancy &occupancy)
{
    const std::int64_t rows = occupancy.layout().rows();
    const std::int64_t columns = occupancy.layout().columns();
    const std::int64_t skew = rows / 2;  // q is that far below 0 in the last row
    const std::int64_t across = columns + skew + 2 * margin;
    const auto wordsFor = [](std::int64_t positions)
    {
        return (positions + 63) / 64;
    };
    // east: a line for every s, in it q grows; north-west: for every q, s falls; south-west: for every q + s, s grows
    const std::array<std::int64_t, directions> lines = {rows + 2 * margin, across, across};
    const std::array<std::int64_t, directions> positions = {across, rows + 2 * margin, rows + 2 * margin};
    for (unsigned int d = 0; d < directions; ++d)
    {
        planes_[d].lines = lines[d];
        planes_[d].lineWords = wordsFor(positions[d]);
        planes_[d].words.assign(static_cast<std::size_t>(lines[d] * planes_[d].lineWords), {allBlocked, 0});
    }
    const auto set = [this](unsigned int d, std::int64_t line, std::int64_t position, std::int64_t lineQ,
                            std::int64_t lineS, std::int64_t positionQ, std::int64_t positionS)
    {
        Plane &plane = planes_[d];
        plane.origin = line * 64 * plane.lineWords + position;
        plane.perQ = lineQ * 64 * plane.lineWords + positionQ;
        plane.perS = lineS * 64 * plane.lineWords + positionS;
    };
    set(0, margin, skew + margin, 0, 1, 1, 0);
    set(1, skew + margin, rows - 1 + margin, 1, 0, 0, -1);
    set(2, margin, margin, 1, 1, 0, 1);

    const Rows bits(occupancy);
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t w = 0; w < planes_[0].lineWords; ++w)
            planes_[0].words[static_cast<std::size_t>((row + margin) * planes_[0].lineWords + w)].blocked =
                bits.from(columnOf(64 * w - skew - margin, row), row);
    std::array<std::uint64_t, 64> block;
    for (const unsigned int d : {1U, 2U})
    {
        Plane &plane = planes_[d];
        for (std::int64_t line = 0; line < plane.lines; line += 64)
            for (std::int64_t w = 0; w < plane.lineWords; ++w)
            {
                for (std::int64_t i = 0; i < 64; ++i)
                {
                    const std::int64_t position = 64 * w + i - margin;
                    const std::int64_t s = d == 1 ? rows - 1 - position : position;
                    const std::int64_t q = d == 1 ? line - skew - margin : line - margin - s;
                    block[static_cast<std::size_t>(i)] = bits.from(columnOf(q, s), s);
                }
                transpose(block);
                const std::int64_t count = std::min<std::int64_t>(64, plane.lines - line);
                for (std::int64_t k = 0; k < count; ++k)
                    plane.words[static_cast<std::size_t>((line + k) * plane.lineWords + w)].blocked =
                        block[static_cast<std::size_t>(k)];
            }
    }

    // on the line below and the line above: how far the neighbour behind lies beside a cell; that ahead is one further
    constexpr std::array<int, directions> behindBelow = {0, -1, -1};
    constexpr std::array<int, directions> behindAbove = {-1, 0, 0};
    for (unsigned int d = 0; d < directions; ++d)
    {
        Plane &plane = planes_[d];
        const std::int64_t n = plane.lineWords;
        const auto ends = [n](const Pair *line, std::int64_t w, int behind)
        {
            return shifted(line, n, w, behind) & ~shifted(line, n, w, behind + 1);
        };
        for (std::int64_t line = 1; line + 1 < plane.lines; ++line)
        {
            Pair *const here = plane.words.data() + line * n;
            for (std::int64_t w = 0; w < n; ++w)
                here[w].turns =
                    ~here[w].blocked & (ends(here - n, w, behindBelow[d]) | ends(here + n, w, behindAbove[d]));
        }
    }
}

std::size_t HexRays::bytes() const
{
    std::size_t sum = 0;
    for (const Plane &plane : planes_)
        sum += plane.words.size() * sizeof(Pair);
    return sum;
}

}  // namespace seahex
