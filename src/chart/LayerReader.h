#pragma once

#include "CellContents.h"
#include "FeatureFields.h"
#include "GdalDataset.h"
#include "OgrShape.h"

#include <seahex/chart/HazardCatalogue.h>

#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <string>

namespace seahex
{

/// Turns the features of one layer into hazards and coverage of a cell.
///
/// Every feature is counted as read and then either used or skipped with a reason; none is lost without a word.
class LayerReader
{
public:
    /// @param objectClass  S-57 acronym of all the layer's features
    /// @param messages  where the driver's words go: some of them mean that a geometry is damaged
    LayerReader(OGRLayer &layer, std::string objectClass, DriverMessages &messages, CellContents &cell);

    /// The layer's coordinates are known to be WGS-84 degrees: it takes longer to find that out than to read most
    /// layers of a cell.
    struct InDegrees
    {
    };
    LayerReader(OGRLayer &layer, std::string objectClass, DriverMessages &messages, CellContents &cell, InDegrees);

    /// @throws ChartDamaged for an object of a blocking class with no or a broken geometry; ChartUnsupported for depths
    ///         that are not in metres
    void read();

private:
    void readFeature(const OGRFeature &feature, bool isBroken);
    void readCoverage(const OGRFeature &feature);
    void readUnits(const OGRFeature &feature);
    void readContour(const OGRFeature &feature);
    void readSounding(const OGRFeature &feature);
    void readHazard(const OGRFeature &feature);
    bool isContour() const;
    bool isJudged() const;
    std::string whyNotJudged() const;
    Shape shapeOf(const OGRFeature &feature) const;
    std::shared_ptr<const OGRGeometry> geometryInDegrees(const OGRFeature &feature) const;
    bool isExpectedOnChart(const OGRFeature &feature) const;
    HazardObject objectOf(const OGRFeature &feature) const;
    Who nameOf(const OGRFeature &feature) const;
    std::string who(const OGRFeature &feature) const;

    OGRLayer &layer_;
    std::string objectClass_;
    const HazardClass *row_;  ///< of the catalogue; null for a class that it does not have
    DriverMessages &messages_;
    CellContents &cell_;
    FeatureFields fields_;
    std::unique_ptr<OGRCoordinateTransformation> toDegrees_;  ///< null where the layer is in WGS-84 degrees
    double longestEdge_ = 0.0;  ///< edges of a projected layer are cut to this before they are bent; 0: no need
};

}  // namespace seahex
