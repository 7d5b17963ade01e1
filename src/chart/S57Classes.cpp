#include "S57Classes.h"

#include "seahex/chart/HazardCatalogue.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>

namespace seahex
{
namespace
{

/// The classes of S-57 beside those of the hazard catalogue, sorted.
constexpr std::string_view OTHER_CLASSES[] = {
    "ADMARE", "AIRARE", "ARCSLN", "ASLXIS", "BERTHS", "BUAARE", "BUISGL", "CANALS", "CANBNK", "CGUSTA",
    "CHKPNT", "CONZNE", "COSARE", "CTRPNT", "CURENT", "CUSZNE", "C_AGGR", "C_ASSO", "C_STAC", "DISMAR",
    "DOCARE", "DWRTCL", "EXEZNE", "FNCLNE", "FOGSIG", "FRPARE", "FSHGRD", "FSHZNE", "GRIDRN", "HRBFAC",
    "ICNARE", "LAKARE", "LAKSHR", "LIGHTS", "LNDELV", "LNDMRK", "LNDRGN", "LOCMAG", "MAGVAR", "M_COVR",
    "M_HDAT", "M_HOPA", "M_NPUB", "M_NSYS", "M_PROD", "M_UNIT", "NAVLNE", "PILBOP", "PRDARE", "RADLNE",
    "RADRFL", "RADRNG", "RADSTA", "RAILWY", "RAPIDS", "RCTLPT", "RDOCAL", "RDOSTA", "RETRFL", "RIVBNK",
    "RIVERS", "ROADWY", "RSCSTA", "RTPBCN", "RUNWAY", "SBDARE", "SEAARE", "SILTNK", "SISTAT", "SISTAW",
    "SLOGRD", "SLOTOP", "SMCFAC", "SPRING", "SQUARE", "STSLNE", "TESARE", "TIDEWY", "TOPMAR", "TS_FEB",
    "TS_PAD", "TS_PNH", "TS_PRH", "TS_TIS", "T_HMON", "T_NHMN", "T_TIMS", "VEGATN", "WATFAL"};

}  // namespace

bool isS57Class(const std::string &acronym)
{
    return findHazardClass(acronym) != nullptr ||
           std::binary_search(std::begin(OTHER_CLASSES), std::end(OTHER_CLASSES), std::string_view(acronym));
}

std::string whyNotJudged(const std::string &acronym)
{
    if (acronym.rfind("M_", 0) == 0)
        return "meta object";
    if (acronym.rfind("C_", 0) == 0)
        return "collection of objects";
    return isS57Class(acronym) ? "class without a rule" : "class unknown";
}

std::string s57ClassOf(const std::string &layerName)
{
    std::string upper = layerName;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
    return isS57Class(upper) ? upper : std::string();
}

}  // namespace seahex
