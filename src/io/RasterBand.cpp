#include "RasterBand.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace seahex
{
namespace
{

/// Values read at a time, at most: 32 MB of doubles.
constexpr int MOST_VALUES = 1 << 22;

std::string shown(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::string textOf(const char *text)
{
    return text == nullptr ? "" : text;
}

std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

bool isMetre(const std::string &unit)
{
    const std::string name = lowerCase(unit);
    return name.empty() || name == "m" || name == "metre" || name == "metres" || name == "meter" || name == "meters";
}

/// The grids that a container holds, by the names under which they open.
std::string subdatasets(GDALDataset &dataset)
{
    std::string names;
    char **entries = dataset.GetMetadata("SUBDATASETS");
    for (int i = 1;
         const char *name = CSLFetchNameValue(entries, ("SUBDATASET_" + std::to_string(i) + "_NAME").c_str()); ++i)
        names += (names.empty() ? "" : ", ") + std::string(name);
    return names;
}

bool axesAreDegrees(GDALDataset &dataset)
{
    for (char **entry = dataset.GetMetadata(); entry != nullptr && *entry != nullptr; ++entry)
        if (std::string(*entry).find("#units=degrees_east") != std::string::npos)
            return true;
    return false;
}

}  // namespace

RasterBand::RasterBand(const std::string &path, const BathymetryOptions &options)
    : name_(path + ", band " + std::to_string(options.band)), noData_(options.noData)
{
    const DriverMessages messages;
    dataset_ = openRaster(path);
    if (!dataset_)
        throw BathymetryError(path + " is no raster that can be read: " + messages.last());
    if (dataset_->GetRasterCount() == 0)
    {
        const std::string names = subdatasets(*dataset_);
        throw BathymetryError(path + (names.empty() ? " holds no raster" : " holds several grids; name one: " + names));
    }
    if (options.band < 1 || options.band > dataset_->GetRasterCount())
        refuse("there is no such band among the " + std::to_string(dataset_->GetRasterCount()) + " of the file");
    band_ = dataset_->GetRasterBand(options.band);
    checkBand();
    if (noData_ && band_->GetRasterDataType() == GDT_Float32)
        noData_ = static_cast<float>(*noData_);
    scale_ = band_->GetScale();
    offset_ = band_->GetOffset();
    if (!std::isfinite(scale_) || scale_ == 0.0 || !std::isfinite(offset_))
        refuse("scale " + shown(scale_) + " and offset " + shown(offset_) + " make no depths");
    heights_ = decideHeights(options.values);
    place(options.coordinates);
}

void RasterBand::refuse(const std::string &why) const
{
    throw BathymetryError(name_ + ": " + why);
}

std::string RasterBand::driver() const
{
    return textOf(dataset_->GetDriver()->GetDescription());
}

void RasterBand::checkBand() const
{
    if (GDALDataTypeIsComplex(band_->GetRasterDataType()) != 0)
        refuse("its values are complex numbers (" + textOf(GDALGetDataTypeName(band_->GetRasterDataType())) +
               "), not depths");
    const GDALColorInterp colour = band_->GetColorInterpretation();
    if (band_->GetColorTable() != nullptr || (colour != GCI_Undefined && colour != GCI_GrayIndex))
        refuse("it is a picture (" + textOf(GDALGetColorInterpretationName(colour)) + "), not depths");
    if (!isMetre(textOf(band_->GetUnitType())))
        refuse("its unit is '" + textOf(band_->GetUnitType()) + "'; only metres are read");
}

bool RasterBand::decideHeights(RasterValues wanted) const
{
    if (wanted != RasterValues::Automatic)
        return wanted == RasterValues::Heights;
    const std::string positive = lowerCase(textOf(band_->GetMetadataItem("positive")));
    const std::string standardName = lowerCase(textOf(band_->GetMetadataItem("standard_name")));
    return positive.empty() ? standardName.find("depth") == std::string::npos : positive != "down";
}

bool RasterBand::decideDegrees(RasterCoordinates wanted, double &metresPerUnit) const
{
    const OGRSpatialReference *frame = dataset_->GetSpatialRef();
    if (wanted != RasterCoordinates::Automatic)
        return wanted == RasterCoordinates::Degrees;
    if (frame == nullptr || frame->IsEmpty())
    {
        if (!axesAreDegrees(*dataset_))
            refuse("it has no coordinate system; say whether its coordinates are degrees or metres");
        return true;
    }
    if (frame->IsGeographic() != 0)
    {
        constexpr double degree = 3.14159265358979323846 / 180.0;
        if (std::abs(frame->GetAngularUnits() / degree - 1.0) > 1e-9)
            refuse("its angles are not in degrees but in units of " + shown(frame->GetAngularUnits()) + " radians");
        return true;
    }
    if (frame->IsProjected() == 0 && frame->IsLocal() == 0)
        refuse("its coordinate system '" + textOf(frame->GetName()) + "' is neither of a plane nor of degrees");
    metresPerUnit = frame->GetLinearUnits();
    return false;
}

void RasterBand::place(RasterCoordinates wanted)
{
    double transform[6];
    if (dataset_->GetGeoTransform(transform) != CE_None)
        refuse("nothing says where its pixels lie (no geotransform)");
    double metresPerUnit = 1.0;
    degrees_ = decideDegrees(wanted, metresPerUnit);
    for (double &number : transform)
        number *= metresPerUnit;
    if (transform[2] != 0.0 || transform[4] != 0.0)
        refuse("it is rotated or sheared (geotransform terms " + shown(transform[2]) + " and " + shown(transform[4]) +
               ")");
    eastStep_ = transform[1];
    northStep_ = transform[5];
    firstCentre_ = Point(transform[0] + 0.5 * eastStep_, transform[3] + 0.5 * northStep_);
    if (!firstCentre_.allFinite() || !(eastStep_ > 0.0) || !std::isfinite(eastStep_) || northStep_ == 0.0 ||
        !std::isfinite(northStep_))
        refuse("its pixels are " + shown(eastStep_) + " by " + shown(northStep_) +
               "; columns must run from west to east, and rows to the south or to the north");
    const double lastNorth = centre(0, dataset_->GetRasterYSize() - 1).y();
    if (degrees_ && std::max(std::abs(firstCentre_.y()), std::abs(lastNorth)) > 90.0)
        refuse("its rows reach from latitude " + shown(firstCentre_.y()) + " to " + shown(lastNorth) +
               ", beyond a pole");
}

PixelWindow RasterBand::window(const std::optional<Box> &box) const
{
    PixelWindow window{0, 0, dataset_->GetRasterXSize(), dataset_->GetRasterYSize()};
    if (box)
    {
        const Point a(box->min.x() - firstCentre_.x(), box->min.y() - firstCentre_.y());
        const Point b(box->max.x() - firstCentre_.x(), box->max.y() - firstCentre_.y());
        const auto rows = std::minmax({a.y() / northStep_, b.y() / northStep_});
        const double lastColumn = window.columns - 1;
        const double lastRow = window.rows - 1;
        // A window that was taken from the grid itself must not gain a row by rounding.
        constexpr double same = 1e-9;
        const double west = std::clamp(std::floor(a.x() / eastStep_ + same), 0.0, lastColumn);
        const double east = std::clamp(std::ceil(b.x() / eastStep_ - same), 0.0, lastColumn);
        const double first = std::clamp(std::floor(rows.first + same), 0.0, lastRow);
        const double last = std::clamp(std::ceil(rows.second - same), 0.0, lastRow);
        if (!(a.x() <= b.x()) || !(a.y() <= b.y()) || !(east > west) || !(last > first))
            refuse("the window " + shown(box->min.x()) + " to " + shown(box->max.x()) + " east, " +
                   shown(box->min.y()) + " to " + shown(box->max.y()) +
                   " north encloses no cell of it: its nodes reach from " + shown(firstCentre_.x()) + " to " +
                   shown(centre(window.columns - 1, 0).x()) + " and from " + shown(firstCentre_.y()) + " to " +
                   shown(centre(0, window.rows - 1).y()) + (degrees_ ? " degrees" : " metres"));
        window = {static_cast<int>(west), static_cast<int>(first), static_cast<int>(east - west) + 1,
                  static_cast<int>(last - first) + 1};
    }
    if (window.columns < 2 || window.rows < 2)
        refuse("it has " + std::to_string(window.columns) + " x " + std::to_string(window.rows) +
               " pixels, and a surface needs 2 x 2 at least");
    return window;
}

void RasterBand::read(const PixelWindow &piece, std::vector<double> &values, std::vector<unsigned char> &mask) const
{
    const DriverMessages messages;
    const std::size_t count = static_cast<std::size_t>(piece.columns) * static_cast<std::size_t>(piece.rows);
    values.resize(count);
    const auto failed = [&]
    {
        refuse("pixels from column " + std::to_string(piece.column) + ", row " + std::to_string(piece.row) +
               " can't be read: " + messages.last());
    };
    if (band_->RasterIO(GF_Read, piece.column, piece.row, piece.columns, piece.rows, values.data(), piece.columns,
                        piece.rows, GDT_Float64, 0, 0, nullptr) != CE_None)
        failed();
    if ((band_->GetMaskFlags() & GMF_ALL_VALID) == 0)
    {
        mask.resize(count);
        if (band_->GetMaskBand()->RasterIO(GF_Read, piece.column, piece.row, piece.columns, piece.rows, mask.data(),
                                           piece.columns, piece.rows, GDT_Byte, 0, 0, nullptr) != CE_None)
            failed();
    }
    for (std::size_t i = 0; i < count; ++i)
    {
        const bool missing = (!mask.empty() && mask[i] == 0) || (noData_ && values[i] == *noData_);
        values[i] = missing ? std::numeric_limits<double>::quiet_NaN() : values[i] * scale_ + offset_;
    }
}

void RasterBand::forEachPiece(const PixelWindow &window, const Visit &visit) const
{
    int blockColumns = 0;
    int blockRows = 0;
    band_->GetBlockSize(&blockColumns, &blockRows);
    const int pieceColumns = std::min(blockColumns, MOST_VALUES);
    std::vector<double> values;
    std::vector<unsigned char> mask;
    const int endRow = window.row + window.rows;
    const int endColumn = window.column + window.columns;
    for (int row = window.row; row < endRow;)
    {
        const int endOfBlocks = std::min(endRow - row, blockRows - row % blockRows) + row;
        for (int column = window.column; column < endColumn;)
        {
            const int columns = std::min(endColumn - column, pieceColumns - column % pieceColumns);
            const int mostRows = std::max(1, MOST_VALUES / columns);
            for (int first = row; first < endOfBlocks; first += mostRows)
            {
                const PixelWindow piece{column, first, columns, std::min(mostRows, endOfBlocks - first)};
                read(piece, values, mask);
                for (int i = 0; i < piece.rows; ++i)
                    visit(column, first + i,
                          values.data() + static_cast<std::size_t>(i) * static_cast<std::size_t>(columns), columns);
            }
            column += columns;
        }
        // GDAL would keep the blocks until its cache is full, and that is a share of the machine's memory.
        band_->FlushCache(false);
        row = endOfBlocks;
    }
}

}  // namespace seahex
