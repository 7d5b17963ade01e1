#pragma once

#include <gdal_priv.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace seahex
{

/// Collects what GDAL's drivers say on this thread while the object lives, instead of printing it.
///
/// Lives on the stack; several may be nested, the innermost hears everything.
class DriverMessages
{
public:
    DriverMessages();
    ~DriverMessages();
    DriverMessages(const DriverMessages &) = delete;
    DriverMessages &operator=(const DriverMessages &) = delete;

    /// Each message once, in order, on one line.
    std::vector<std::string> lines() const;

    /// Forgets what recent() holds.
    void listenAnew() { recent_.clear(); }

    /// All that was said since listenAnew(), repetitions included; empty if nothing was.
    const std::string &recent() const { return recent_; }

    /// The newest message, empty if there is none.
    const std::string &last() const { return last_; }

private:
    static void CPL_STDCALL hear(CPLErr severity, CPLErrorNum number, const char *message);

    /// More different messages than a person reads are only counted.
    static constexpr std::size_t MAX_LINES = 100;

    std::vector<std::string> lines_;
    std::string last_;
    std::string recent_;
    std::size_t unkept_ = 0;
};

struct CloseDataset
{
    void operator()(GDALDataset *dataset) const { GDALClose(dataset); }
};
using GdalDataset = std::unique_ptr<GDALDataset, CloseDataset>;

/// Opens a vector source for reading, or returns nullptr (the driver's words are then in the DriverMessages).
/// @param drivers  short names of the drivers that may try; empty for all
GdalDataset openVector(const std::string &path, const std::vector<std::string> &drivers,
                       const std::vector<std::string> &openOptions);

/// Opens a raster for reading, or returns nullptr.
GdalDataset openRaster(const std::string &path);

}  // namespace seahex
