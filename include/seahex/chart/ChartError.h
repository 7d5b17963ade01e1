#pragma once

#include <stdexcept>

namespace seahex
{

/// Base of everything that a chart source can do wrong. The message names file, layer, feature, value and unit.
class ChartError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// The source can't be opened: missing, not a chart, a folder with no chart in it.
class ChartUnreadable : public ChartError
{
public:
    using ChartError::ChartError;
};

/// The source opens but is damaged: fewer records than its header promises, an object of a blocking class with no
/// geometry, a coordinate that is not a number.
class ChartDamaged : public ChartError
{
public:
    using ChartError::ChartError;
};

/// The source is sound but of a kind that can't be used safely: depths not in metres, no layer with an S-57 name.
class ChartUnsupported : public ChartError
{
public:
    using ChartError::ChartError;
};

/// The source is sound but holds no water that could be sailed: no coverage, or no depth area.
class ChartEmpty : public ChartError
{
public:
    using ChartError::ChartError;
};

}  // namespace seahex
