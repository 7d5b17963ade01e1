#include "World.h"

#include <cmath>
#include <cstdio>

namespace benchmark_planners
{

std::string logNumber(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", value);
    return text;
}

double toMillionths(double value)
{
    return std::round(value * 1e6) / 1e6;
}

}  // namespace benchmark_planners
