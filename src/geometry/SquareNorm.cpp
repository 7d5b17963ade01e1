#include "seahex/geometry/SquareNorm.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace seahex
{
namespace
{

const double diagonal = std::sqrt(2.0);

double octile(double a, double b)
{
    return std::max(a, b) - std::min(a, b) + diagonal * std::min(a, b);
}

}  // namespace

double squareNorm(OffsetCoord difference, int neighbours)
{
    const auto columns = static_cast<double>(std::abs(difference.column));
    const auto rows = static_cast<double>(std::abs(difference.row));
    return neighbours == 4 ? columns + rows : octile(columns, rows);
}

double octileNorm(const Point &vector, double pitch)
{
    return octile(std::abs(vector.x()) / pitch, std::abs(vector.y()) / pitch);
}

}  // namespace seahex
