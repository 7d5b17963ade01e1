#include "Failure.h"

namespace plan_route
{

const char *statusWord(Exit exit)
{
    switch (exit)
    {
        case Exit::Route:
            return "route";
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
        case Exit::Internal:
            break;
    }
    return "internal";
}

}  // namespace plan_route
