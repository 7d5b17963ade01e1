#pragma once

#include <seahex/world/Hazard.h>

#include <string>
#include <vector>

namespace seahex
{

/// One row of the hazard catalogue: how objects of one S-57 class are judged.
struct HazardClass
{
    const char *acronym;
    HazardRule rule;
    double pointRadiusM;  ///< keep-out radius where the geometry is a point, metres
    double lineRadiusM;   ///< keep-out radius where it is a line
    double areaRadiusM;   ///< keep-out radius where it is an area
    bool groupOne;        ///< one of the seven classes that tile the coverage
};

/// The whole table, sorted by acronym.
const std::vector<HazardClass> &hazardCatalogue();

/// The row of one class, or nullptr if the catalogue does not know it.
const HazardClass *findHazardClass(const std::string &acronym);

/// Acronyms of the attributes that are kept with a hazard: those that decide, and those that help a person.
const std::vector<const char *> &keptAttributes();

}  // namespace seahex
