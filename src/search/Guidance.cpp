#include "seahex/search/Guidance.h"

#include <array>
#include <cmath>
#include <utility>

namespace seahex
{
namespace
{

constexpr std::array<std::pair<Guidance, const char *>, 8> names = {{{Guidance::Automatic, "automatic"},
                                                                     {Guidance::None, "none"},
                                                                     {Guidance::Distance, "distance"},
                                                                     {Guidance::Euclidean, "euclidean"},
                                                                     {Guidance::Cheng, "cheng"},
                                                                     {Guidance::Wang, "wang"},
                                                                     {Guidance::TieBreak, "tie_break"},
                                                                     {Guidance::Relaxed, "relaxed"}}};

double cross(const Point &a, const Point &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

const char *toString(Guidance guidance)
{
    for (const auto &[value, name] : names)
        if (value == guidance)
            return name;
    return "";
}

std::string guidanceNames()
{
    std::string all;
    for (const auto &[value, name] : names)
        all += (all.empty() ? "" : ",") + std::string(name);
    return all;
}

std::optional<Guidance> guidanceFromString(const std::string &text)
{
    for (const auto &[value, name] : names)
        if (text == name)
            return value;
    return std::nullopt;
}

double pilotQuantity(const Point &start, const Point &goal, const Point &i)
{
    const Point toStart = start - goal;
    const Point toCell = i - goal;
    const double lengths = toStart.norm() * toCell.norm();
    if (lengths == 0.0)
        return 1.0;
    const double sine = std::min(std::abs(cross(toStart, toCell)) / lengths, 1.0);
    // sin theta = 0 yields 3/4 on the line itself
    return 3.0 / (4.0 - sine);
}

double distanceFromLine(const Point &start, const Point &goal, const Point &p)
{
    const Point along = goal - start;
    const double length = along.norm();
    return length == 0.0 ? 0.0 : std::abs(cross(along, p - start)) / length;
}

}  // namespace seahex
