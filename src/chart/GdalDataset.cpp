#include "GdalDataset.h"

#include <cpl_error.h>

#include <algorithm>
#include <mutex>

namespace seahex
{
namespace
{

std::string onOneLine(const char *message)
{
    std::string line = message == nullptr ? "" : message;
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
}

std::vector<const char *> pointersTo(const std::vector<std::string> &texts)
{
    std::vector<const char *> pointers;
    pointers.reserve(texts.size() + 1);
    for (const std::string &text : texts)
        pointers.push_back(text.c_str());
    pointers.push_back(nullptr);
    return pointers;
}

void registerDrivers()
{
    static std::once_flag registered;
    std::call_once(registered, [] { GDALAllRegister(); });
}

}  // namespace

DriverMessages::DriverMessages()
{
    CPLErrorReset();
    CPLPushErrorHandlerEx(&DriverMessages::hear, this);
}

DriverMessages::~DriverMessages()
{
    CPLPopErrorHandler();
    CPLErrorReset();
}

void CPL_STDCALL DriverMessages::hear(CPLErr severity, CPLErrorNum, const char *message)
{
    if (severity == CE_None || severity == CE_Debug)
        return;
    auto *self = static_cast<DriverMessages *>(CPLGetErrorHandlerUserData());
    self->last_ = onOneLine(message);
    self->recent_ += (self->recent_.empty() ? "" : "; ") + self->last_;
    if (std::find(self->lines_.begin(), self->lines_.end(), self->last_) != self->lines_.end())
        return;
    if (self->lines_.size() < MAX_LINES)
        self->lines_.push_back(self->last_);
    else
        ++self->unkept_;
}

std::vector<std::string> DriverMessages::lines() const
{
    std::vector<std::string> all = lines_;
    if (unkept_ > 0)
        all.push_back("and " + std::to_string(unkept_) + " more messages of the driver");
    return all;
}

GdalDataset openVector(const std::string &path, const std::vector<std::string> &drivers,
                       const std::vector<std::string> &openOptions)
{
    registerDrivers();
    const std::vector<const char *> allowed = pointersTo(drivers);
    const std::vector<const char *> options = pointersTo(openOptions);
    return GdalDataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                         drivers.empty() ? nullptr : allowed.data(), options.data()));
}

GdalDataset openRaster(const std::string &path)
{
    registerDrivers();
    return GdalDataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
}

}  // namespace seahex
