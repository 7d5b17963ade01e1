#pragma once

#include <seahex/io/Picture.h>
#include <seahex/io/PictureFrame.h>
#include <seahex/io/PicturePalette.h>

#include <gdal.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace seahex::test
{

using Rgb = std::array<int, 3>;

inline Rgb rgb(const Colour &colour)
{
    const auto byte = [](double component)
    {
        return static_cast<int>(std::lround(255.0 * component));
    };
    return {byte(colour.red), byte(colour.green), byte(colour.blue)};
}

inline testing::AssertionResult isNear(const Rgb &found, const Colour &expected, int tolerance = 3)
{
    const Rgb e = rgb(expected);
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(found[i] - e[i]) > tolerance)
            return testing::AssertionFailure()
                   << testing::PrintToString(found) << " instead of " << testing::PrintToString(e);
    return testing::AssertionSuccess();
}

/// A picture read back, by a reader that knows nothing of cairo.
class Image
{
public:
    explicit Image(const std::string &path)
    {
        GDALAllRegister();
        GDALDatasetH file = GDALOpen(path.c_str(), GA_ReadOnly);
        if (file == nullptr)
            throw std::runtime_error("can't read " + path);
        width_ = GDALGetRasterXSize(file);
        height_ = GDALGetRasterYSize(file);
        for (std::size_t i = 0; i < 3; ++i)
        {
            bands_[i].resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
            if (GDALRasterIO(GDALGetRasterBand(file, static_cast<int>(i) + 1), GF_Read, 0, 0, width_, height_,
                             bands_[i].data(), width_, height_, GDT_Byte, 0, 0) != CE_None)
                throw std::runtime_error("can't read the pixels of " + path);
        }
        GDALClose(file);
    }

    int width() const { return width_; }
    int height() const { return height_; }

    Rgb at(int x, int y) const
    {
        const std::size_t i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
        return {bands_[0][i], bands_[1][i], bands_[2][i]};
    }
    Rgb at(const Point &page) const
    {
        return at(static_cast<int>(std::floor(page.x())), static_cast<int>(std::floor(page.y())));
    }

    /// The colour of most pixels around a place, whatever thin lines cross it.
    Rgb around(const Point &page, int reach) const
    {
        std::map<Rgb, int> votes;
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx)
                ++votes[at(page + Point(dx, dy))];
        const auto most = std::max_element(votes.begin(), votes.end(),
                                           [](const auto &a, const auto &b) { return a.second < b.second; });
        return most->first;
    }

private:
    int width_ = 0;
    int height_ = 0;
    std::array<std::vector<unsigned char>, 3> bands_;
};

inline std::string contentsOf(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The occupancy of a lattice in which these cells, and no others of the rectangle, are blocked.
inline std::shared_ptr<const Occupancy> occupancyOf(const Lattice &lattice, const std::vector<OffsetCoord> &blocked)
{
    const CellLayout layout(lattice.columns(), lattice.rows());
    std::vector<std::uint64_t> words(layout.wordCount(), ~std::uint64_t{0});
    const auto bit = [](CellIndex i)
    {
        return std::uint64_t{1} << (i & 63);
    };
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < lattice.columns(); ++column)
        {
            const CellIndex i = layout.index(OffsetCoord{column, row});
            words[i >> 6] &= ~bit(i);
        }
    for (const OffsetCoord cell : blocked)
        words[layout.index(cell) >> 6] |= bit(layout.index(cell));
    return std::make_shared<const Occupancy>(lattice, layout, std::move(words));
}

inline const Projection &metricFrame()
{
    static const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(60.0, 5.0));
    return projection;
}

/// A test that writes pictures into a folder of its own.
class Picture : public testing::Test
{
protected:
    void SetUp() override
    {
        folder_ =
            std::filesystem::path(testing::TempDir()) / ("seahex_picture_" + std::to_string(std::random_device{}()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string &name) const { return (folder_ / name).string(); }

    std::vector<std::string> files() const
    {
        std::vector<std::string> names;
        for (const auto &entry : std::filesystem::directory_iterator(folder_))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

    /// What writePicture says went wrong, or "" if nothing did.
    std::string complaint(const std::string &file, const PictureContent &content) const
    {
        try
        {
            writePicture(path(file), content);
        }
        catch (const PictureError &error)
        {
            return error.what();
        }
        return "";
    }

    std::filesystem::path folder_;
};

}  // namespace seahex::test
