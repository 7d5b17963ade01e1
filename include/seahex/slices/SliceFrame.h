#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <optional>

namespace seahex
{

/// A grid point of a slice: how far across it lies, and on which level.
struct SliceCell
{
    int across = 0;
    int level = 0;

    friend bool operator==(const SliceCell &a, const SliceCell &b)
    {
        return a.across == b.across && a.level == b.level;
    }
    friend bool operator!=(const SliceCell &a, const SliceCell &b) { return !(a == b); }
};

/// Where the axis points that slices stand across.
enum class SliceAxis
{
    Course,  ///< from the start to the goal, in the horizontal plane
    X,       ///< along x, towards the goal: the planes YOZ of [Xu]
    Y        ///< along y, towards the goal
};

/// How many slices, and how many grid points each of them has, across and up. At least two of each.
struct SliceResolution
{
    int planes = 25;
    int across = 25;
    int levels = 25;
};

/// Vertical planes at equal distances, the first through the start and the last through the goal, with the same grid of
/// points on each of them ([Xu], the space cut into planes YOZ).
///
/// The grid spans what the planes have in common with a box of bounds: levels from its least to its greatest z, points
/// across from the least to the greatest offset that any plane has in it. Where the axis is oblique to the box, some
/// grid points lie outside.
class SliceFrame
{
public:
    /// @return nothing if start and goal are one above the other as seen along the axis, so that there is no room for
    /// planes between them
    static std::optional<SliceFrame> between(const Eigen::Vector3d &start, const Eigen::Vector3d &goal,
                                             const Eigen::AlignedBox3d &bounds, const SliceResolution &resolution,
                                             SliceAxis axis);

    int planes() const { return resolution_.planes; }
    int across() const { return resolution_.across; }
    int levels() const { return resolution_.levels; }
    /// Grid points of one plane.
    std::size_t cellCount() const
    {
        return static_cast<std::size_t>(resolution_.across) * static_cast<std::size_t>(resolution_.levels);
    }
    bool contains(SliceCell cell) const
    {
        return cell.across >= 0 && cell.across < across() && cell.level >= 0 && cell.level < levels();
    }
    /// Cells are numbered column by column, from the lowest level up.
    std::size_t index(SliceCell cell) const
    {
        return static_cast<std::size_t>(cell.across) * static_cast<std::size_t>(resolution_.levels) +
               static_cast<std::size_t>(cell.level);
    }
    SliceCell cell(std::size_t index) const
    {
        const auto number = static_cast<int>(index);
        return {number / resolution_.levels, number % resolution_.levels};
    }

    const Eigen::Vector3d &start() const { return start_; }
    const Eigen::Vector3d &goal() const { return goal_; }

    /// Distance between neighbouring planes, across and between levels, in the unit of the space.
    double spacing() const { return (last_ - first_) / (planes() - 1); }
    double acrossStep() const { return (right_ - left_) / (across() - 1); }
    double levelStep() const { return (top_ - bottom_) / (levels() - 1); }

    Eigen::Vector3d position(int plane, SliceCell cell) const;

    /// Where the line through two points meets a plane. The points must not lie in a plane of the frame together.
    Eigen::Vector3d crossing(int plane, const Eigen::Vector3d &a, const Eigen::Vector3d &b) const;

    /// How far across a point lies and how far up, in steps of the grid.
    Eigen::Vector2d gridCoordinates(const Eigen::Vector3d &p) const;

private:
    SliceFrame() = default;
    double along(int plane) const;
    void span(const Eigen::AlignedBox3d &bounds);

    SliceResolution resolution_;
    Eigen::Vector3d start_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d goal_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d ahead_ = Eigen::Vector3d::UnitX();  // the axis
    Eigen::Vector3d aside_ = Eigen::Vector3d::UnitY();
    double first_ = 0.0;  // along the axis: the first plane and the last
    double last_ = 0.0;
    double left_ = 0.0;  // across: the first grid point and the last
    double right_ = 0.0;
    double bottom_ = 0.0;
    double top_ = 0.0;
};

}  // namespace seahex
