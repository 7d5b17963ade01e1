#include "S57Header.h"

#include "seahex/chart/ChartError.h"

#include <ogrsf_frmts.h>

#include <cstdlib>
#include <initializer_list>

namespace seahex
{
namespace
{

std::optional<int> integer(const OGRFeature &record, const char *field)
{
    const int index = record.GetFieldIndex(field);
    if (index < 0 || !record.IsFieldSetAndNotNull(index))
        return std::nullopt;
    return record.GetFieldAsInteger(index);
}

std::string text(const OGRFeature &record, const char *field)
{
    const int index = record.GetFieldIndex(field);
    return index < 0 || !record.IsFieldSetAndNotNull(index) ? std::string() : record.GetFieldAsString(index);
}

std::int64_t sum(const OGRFeature &record, std::initializer_list<const char *> fields)
{
    std::int64_t total = 0;
    for (const char *field : fields)
        total += integer(record, field).value_or(0);
    return total;
}

bool isPrimitive(const std::string &layerName)
{
    return layerName == "IsolatedNode" || layerName == "ConnectedNode" || layerName == "Edge" || layerName == "Face";
}

}  // namespace

S57Header readS57Header(GDALDataset &dataset, const std::string &file)
{
    OGRLayer *layer = dataset.GetLayerByName("DSID");
    if (layer != nullptr)
        layer->ResetReading();
    const OGRFeatureUniquePtr record(layer == nullptr ? nullptr : layer->GetNextFeature());
    if (!record)
        throw ChartDamaged("'" + file + "' has no data set identification (DSID record): the file is cut or damaged");

    S57Header header;
    header.dataSetName = text(*record, "DSID_DSNM");
    header.issueDate = text(*record, "DSID_ISDT");
    header.edition = text(*record, "DSID_EDTN");
    header.updateNumber = std::atoi(text(*record, "DSID_UPDN").c_str());
    header.exchangePurpose = integer(*record, "DSID_EXPP").value_or(0);
    header.scale = integer(*record, "DSPM_CSCL");
    header.verticalDatum = integer(*record, "DSPM_VDAT");
    header.soundingDatum = integer(*record, "DSPM_SDAT");
    header.horizontalDatum = integer(*record, "DSPM_HDAT");
    header.depthUnit = integer(*record, "DSPM_DUNI");
    header.positionUnit = integer(*record, "DSPM_COUN");
    header.gridUnitsPerDegree = integer(*record, "DSPM_COMF").value_or(0);
    header.promisedFeatures = sum(*record, {"DSSI_NOMR", "DSSI_NOCR", "DSSI_NOGR", "DSSI_NOLR"});
    header.promisedSpatials = sum(*record, {"DSSI_NOIN", "DSSI_NOCN", "DSSI_NOED", "DSSI_NOFA"});
    return header;
}

S57Counts countS57Records(GDALDataset &dataset)
{
    S57Counts counts;
    for (int i = 0; i < dataset.GetLayerCount(); ++i)
    {
        OGRLayer *layer = dataset.GetLayer(i);
        const std::string name = layer->GetName();
        if (isPrimitive(name))
            counts.spatials += layer->GetFeatureCount(TRUE);
        else if (!isS57Bookkeeping(name))
            counts.features += layer->GetFeatureCount(TRUE);
    }
    return counts;
}

bool isS57Bookkeeping(const std::string &layerName)
{
    return layerName == "DSID" || isPrimitive(layerName);
}

}  // namespace seahex
