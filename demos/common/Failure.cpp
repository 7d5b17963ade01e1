#include "Failure.h"

#include <cstdio>

namespace demos
{

const char *statusWord(Exit exit)
{
    switch (exit)
    {
        case Exit::Success:
            return "success";
        case Exit::Usage:
            return "usage";
        case Exit::Chart:
            return "chart";
        case Exit::NotNavigable:
            return "not_navigable";
        case Exit::NoRoute:
            return "no_route";
        case Exit::OutOfTime:
            return "out_of_time";
        case Exit::Report:
            return "report";
        case Exit::Internal:
            break;
    }
    return "internal";
}

std::string plain(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

}  // namespace demos
