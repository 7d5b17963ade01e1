#pragma once

#include <seahex/world/Bathymetry.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace seahex::test
{

using Rational = boost::multiprecision::cpp_rational;

/// A seabed in rational arithmetic, written down from its definition alone: bilinear between the nodes, unknown where a
/// closed cell with an unknown corner is touched, unknown outside.
class RationalSeabed
{
public:
    explicit RationalSeabed(const Bathymetry &seabed);

    /// Least of depth - z along the segment; empty if unknown.
    std::optional<Rational> leastWaterBelow(const Point3 &a, const Point3 &b) const;

    /// Least depth of the nodes in a closed box, of the corners of the box, and where its edges cross the grid's lines;
    /// empty if unknown.
    std::optional<Rational> leastDepth(const Box &box) const;

private:
    struct Place
    {
        Rational x;
        Rational y;
    };

    Place steps(const Point &p) const;
    bool isOutside(const Place &p) const;
    /// Does the segment touch a closed cell with an unknown corner?
    bool touchesUnknown(const Place &a, const Place &b) const;
    Rational depth(const Place &p) const;

    const Bathymetry &seabed_;
    std::int64_t lastColumn_;
    std::int64_t lastRow_;
};

}  // namespace seahex::test
