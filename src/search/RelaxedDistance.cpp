#include "seahex/search/RelaxedDistance.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace seahex
{
namespace
{

const double infinity = std::numeric_limits<double>::infinity();
const double root3 = std::sqrt(3.0);
const double root7 = std::sqrt(7.0);

/// Costs on one line, from a first place on; readable `margin` places beyond the rectangle on either side.
class Line
{
public:
    // Moves reach 2 places beyond the ends of a line, and ends move by up to 2 places a line, 3 lines far.
    static constexpr std::int64_t margin = 8;

    Line() = default;
    Line(std::int64_t first, std::int64_t last)
        : begin_(first - margin), costs_(static_cast<std::size_t>(last - first + 1 + 2 * margin), infinity)
    {
    }

    /// Pointer p such that p[k] is the cost at place + k.
    double *at(std::int64_t place) { return costs_.data() + (place - begin_); }
    const double *at(std::int64_t place) const { return costs_.data() + (place - begin_); }

    bool empty() const { return costs_.empty(); }

private:
    std::int64_t begin_ = 0;
    std::vector<double> costs_;
};

}  // namespace

/// The lines on one side of the goal's, that one included. Places are counted as HexLines does, with both signs turned
/// on the side of negative lines.
class RelaxedDistance::Side
{
public:
    Side(const Occupancy &occupancy, const HexLines &lines, int sign, int rings)
        : occupancy_(occupancy), lines_(lines), sign_(sign), rings_(rings)
    {
        const auto [first, last] = extent(0);
        Line line(first, last);
        for (std::int64_t place = first - Line::margin; place <= last + Line::margin; ++place)
            *line.at(place) = static_cast<double>(std::abs(place));
        reachable_ = line;
        free_.push_back(std::move(line));
    }

    std::int64_t count() const { return static_cast<std::int64_t>(free_.size()); }

    double cost(std::int64_t line, std::int64_t place)
    {
        line *= sign_;
        while (count() <= line)
            pass();
        return *free_[static_cast<std::size_t>(line)].at(place * sign_);
    }

    void pass()
    {
        const auto [first, last] = extent(count());
        Line line;
        if (first <= last)
        {
            line = Line(first, last);
            take(line, first, last);
            keepFree(line, first, last);
        }
        free_.push_back(std::move(line));
    }

private:
    std::pair<std::int64_t, std::int64_t> extent(std::int64_t line) const
    {
        const auto [first, last] = lines_.extent(sign_ * line, occupancy_.layout());
        return sign_ > 0 ? std::make_pair(first, last) : std::make_pair(-last, -first);
    }

    const Line &before(std::int64_t lines) const { return free_[free_.size() - static_cast<std::size_t>(lines)]; }

    /// The cheapest move from each cell of the next line. (Loops of their own, for the compiler to make vectors of.)
    void take(Line &line, std::int64_t first, std::int64_t last) const
    {
        const std::int64_t n = last - first + 1;
        double *cost = line.at(first);
        const double *one = reachable_.at(first);
        for (std::int64_t i = 0; i < n; ++i)
            cost[i] = 1.0 + std::min(one[i], one[i + 1]);
        if (rings_ == 1)
            return;
        const double aside = rings_ == 2 ? root3 : root7 - 1.0;
        for (std::int64_t i = 0; i < n; ++i)
            cost[i] = std::min(cost[i], aside + std::min(one[i - 1], one[i + 2]));
        if (count() < 2)
            return;
        // What is touched and free costs less than the move, so the larger of the two is the move or infinite.
        const double *freeOne = before(1).at(first);
        const double *freeTwo = before(2).at(first);
        for (std::int64_t i = 0; i < n; ++i)
            cost[i] = std::min(cost[i], std::max(root3 + freeTwo[i + 1], std::max(freeOne[i], freeOne[i + 1])));
        if (rings_ == 2 || count() < 3)
            return;
        const double *freeThree = before(3).at(first);
        for (std::int64_t i = 0; i < n; ++i)
        {
            const double left = std::max(root7 + freeThree[i + 1], std::max(freeOne[i], freeTwo[i + 1]));
            const double right = std::max(root7 + freeThree[i + 2], std::max(freeOne[i + 1], freeTwo[i + 1]));
            cost[i] = std::min(cost[i], std::min(left, right));
        }
    }

    /// Costs of entering the line: at free cells, and beside them through anything.
    void keepFree(Line &line, std::int64_t first, std::int64_t last)
    {
        reachable_ = line;
        std::int64_t blockedFrom = first - Line::margin;
        std::int64_t place = first;
        bool isOpen = false;
        const auto visit = [&](CellIndex index)
        {
            if (occupancy_.isBlockedAt(index) == isOpen)
            {
                if (isOpen)
                    blockedFrom = place;
                else
                    block(line, blockedFrom, place, first, last);
                isOpen = !isOpen;
            }
            ++place;
        };
        lines_.forEachCell(sign_ * count(), sign_ * first, sign_ * last, occupancy_.layout(), visit);
        block(line, isOpen ? place : blockedFrom, last + 1 + Line::margin, first, last);
    }

    /// Blocks the places from `begin` to before `end`.
    void block(Line &line, std::int64_t begin, std::int64_t end, std::int64_t first, std::int64_t last)
    {
        const double left = begin > first ? *reachable_.at(begin - 1) : infinity;
        const double right = end <= last ? *reachable_.at(end) : infinity;
        double *reachable = reachable_.at(begin);
        double *free = line.at(begin);
        const std::int64_t n = end - begin;
        for (std::int64_t i = 0; i < n; ++i)
        {
            reachable[i] = std::min(left + static_cast<double>(i + 1), right + static_cast<double>(n - i));
            free[i] = infinity;
        }
    }

    const Occupancy &occupancy_;
    const HexLines &lines_;
    const int sign_;
    const int rings_;
    std::vector<Line> free_;  // by line: h of free cells, infinity elsewhere
    Line reachable_;          // of the last line: the same, and beside free cells what it costs to go along
};

RelaxedDistance::RelaxedDistance(std::shared_ptr<const Occupancy> occupancy, HexCoord start, HexCoord goal, int rings)
    : occupancy_(std::move(occupancy)), lines_(HexLines::across(start, goal)),
      startLine_(lines_.placeOf(start).line), sides_{std::make_unique<Side>(*occupancy_, lines_, 1, rings),
                                                     std::make_unique<Side>(*occupancy_, lines_, -1, rings)}
{
}

RelaxedDistance::~RelaxedDistance() = default;

bool RelaxedDistance::passNextLine()
{
    Side &side = sideOf(startLine_);
    if (side.count() > std::abs(startLine_))
        return false;
    side.pass();
    return true;
}

double RelaxedDistance::operator()(HexCoord cell)
{
    const HexLines::Place at = lines_.placeOf(cell);
    return sideOf(at.line).cost(at.line, at.place);
}

}  // namespace seahex
