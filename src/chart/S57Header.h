#pragma once

#include "GdalDataset.h"

#include <cstdint>
#include <optional>
#include <string>

namespace seahex
{

/// What the DSID record of an S-57 file says of it.
struct S57Header
{
    std::string dataSetName;  ///< DSNM, "US5MA12M.000"
    std::string issueDate;    ///< ISDT
    std::string edition;      ///< EDTN
    int updateNumber = 0;     ///< UPDN
    int exchangePurpose = 0;  ///< EXPP: 1 a base cell, 2 an update
    std::optional<int> scale;
    std::optional<int> verticalDatum;
    std::optional<int> soundingDatum;
    std::optional<int> horizontalDatum;
    std::optional<int> depthUnit;
    std::optional<int> positionUnit;
    double gridUnitsPerDegree = 0.0;    ///< COMF
    std::int64_t promisedFeatures = 0;  ///< DSSI: NOMR + NOCR + NOGR + NOLR
    std::int64_t promisedSpatials = 0;  ///< DSSI: NOIN + NOCN + NOED + NOFA
};

/// How many records a file really holds.
struct S57Counts
{
    std::int64_t features = 0;
    std::int64_t spatials = 0;
};

/// @param file  names the file in a message
/// @throws ChartDamaged if there is no DSID record
S57Header readS57Header(GDALDataset &dataset, const std::string &file);

/// @param dataset  opened with RETURN_PRIMITIVES=ON, SPLIT_MULTIPOINT=OFF and without updates
S57Counts countS57Records(GDALDataset &dataset);

/// True for the layers that describe the file or hold its topology, not its objects.
bool isS57Bookkeeping(const std::string &layerName);

}  // namespace seahex
