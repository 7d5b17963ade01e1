#pragma once

#include "seahex/geometry/Box.h"
#include "seahex/io/BathymetryReader.h"

#include "chart/GdalDataset.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace seahex
{

/// A rectangle of pixels.
struct PixelWindow
{
    int column = 0;
    int row = 0;  ///< as the file counts
    int columns = 0;
    int rows = 0;
};

/// One band of a raster, opened and found to be a regular grid of real numbers in known coordinates.
///
/// Messages of refusal begin with the file and the band.
class RasterBand
{
public:
    /// @throws BathymetryError as readBathymetry
    RasterBand(const std::string &path, const BathymetryOptions &options);

    bool isInDegrees() const { return degrees_; }
    bool areHeights() const { return heights_; }
    /// Do the rows run from north to south?
    bool isNorthUp() const { return northStep_ < 0.0; }
    std::string driver() const;

    /// The pixels whose centres enclose what of the box lies between the raster's first and last centres.
    /// @throws BathymetryError if nothing does, or fewer than 2 x 2
    PixelWindow window(const std::optional<Box> &box) const;

    /// Centre of a pixel in the raster's coordinates (degrees, or metres).
    Point centre(int column, int row) const
    {
        return {firstCentre_.x() + column * eastStep_, firstCentre_.y() + row * northStep_};
    }
    /// From one pixel to the next, both positive.
    Point spacing() const { return {eastStep_, std::abs(northStep_)}; }

    /// Visits all values of a window, scaled, in pieces of rows: visit(column, row, values, count), the values of
    /// pixels from (column, row) eastward. What is no data is not a number.
    /// @throws BathymetryError if a block can't be read
    using Visit = std::function<void(int column, int row, const double *values, int count)>;
    void forEachPiece(const PixelWindow &window, const Visit &visit) const;

    [[noreturn]] void refuse(const std::string &why) const;

private:
    void checkBand() const;
    void place(RasterCoordinates wanted);
    bool decideDegrees(RasterCoordinates wanted, double &metresPerUnit) const;
    bool decideHeights(RasterValues wanted) const;
    void read(const PixelWindow &piece, std::vector<double> &values, std::vector<unsigned char> &mask) const;

    std::string name_;
    std::optional<double> noData_;
    GdalDataset dataset_;
    GDALRasterBand *band_ = nullptr;
    double scale_ = 1.0;
    double offset_ = 0.0;
    bool degrees_ = false;
    bool heights_ = true;
    Point firstCentre_ = Point::Zero();
    double eastStep_ = 0.0;
    double northStep_ = 0.0;
};

}  // namespace seahex
