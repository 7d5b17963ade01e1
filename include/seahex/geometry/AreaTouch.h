#pragma once

#include <seahex/geometry/Shape.h>

#include <cstddef>
#include <vector>

namespace seahex
{

/// Answers again and again whether a shape has a point in common with one area.
///
/// Exact: every decision is the sign of a determinant of the coordinates as they are stored, taken as an expansion of
/// doubles where one double can't tell it ([Shewchuk1997]). A touch at the boundary is a touch. What is inside is
/// told by the even-odd rule, so a ring that crosses itself leaves out what it runs round twice.
///
/// The edges are filed by strips of y: making one takes time linear in the edges, an answer the edges of the strips
/// that the shape meets. Immutable; const functions, thread-safe.
class AreaTouch
{
public:
    /// @param area  must outlive this, and its coordinates must be finite
    explicit AreaTouch(const Polygon &area);

    /// True if any point of the shape (its areas are filled) lies in the area or on its boundary.
    bool touches(const Shape &shape) const;

    /// True if the point lies in the area or on its boundary.
    bool touches(const Point &p) const;

private:
    enum class Place
    {
        Outside,
        Boundary,
        Inside
    };

    std::size_t stripOf(double y) const;
    template <class Visit>
    void forEachEdge(Visit &&visit) const;
    Place locate(const Point &p) const;
    bool boundaryMeets(const Point &a, const Point &b) const;
    template <class Path>
    bool boundaryMeetsPath(const Path &path) const;
    bool touchesArea(const Polygon &other) const;

    const Polygon &area_;
    double south_ = 0.0;
    double stripsPerUnit_ = 0.0;
    std::vector<std::size_t> stripStart_;  // where the edges of each strip begin
    std::vector<const Point *> edges_;     // an edge by its first corner; the next in the ring is its second
};

}  // namespace seahex
