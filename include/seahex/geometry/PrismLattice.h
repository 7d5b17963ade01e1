#pragma once

#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/Point3.h>

namespace seahex
{

/// Hexagons in the plane times layers of depth: a node is the centre of a hexagon in one of the layers. An immutable
/// value.
class PrismLattice
{
public:
    /// @param top        z of layer 0, metres
    /// @param thickness  from each layer down to the next; > 0
    /// @param layers     > 0
    /// @throws std::domain_error if the thickness is not positive and finite, top not finite, or layers not positive
    PrismLattice(const HexLattice &plane, double top, double thickness, int layers);

    /// Layers at equal distances from `top` to `bottom`, both included, not more than `thickness` apart; one layer if
    /// there is nothing between.
    /// @throws std::domain_error as the constructor, or if that takes more than 10^4 layers
    static PrismLattice between(const HexLattice &plane, double top, double bottom, double thickness);

    const HexLattice &plane() const { return plane_; }
    double pitch() const { return plane_.pitch(); }
    double top() const { return top_; }
    double thickness() const { return thickness_; }
    int layers() const { return layers_; }

    double depth(int layer) const
    {
        return layer + 1 == layers_ ? bottom_ : top_ + static_cast<double>(layer) * thickness_;
    }
    Point3 node(HexCoord cell, int layer) const
    {
        const Point centre = plane_.centre(cell);
        return {centre.x(), centre.y(), depth(layer)};
    }

private:
    HexLattice plane_;
    double top_;
    double thickness_;
    int layers_;
    double bottom_;
};

}  // namespace seahex
