#include "seahex/chart/HazardCatalogue.h"

#include <algorithm>

namespace seahex
{
namespace
{

/// Marks and structures are drawn as points and lines, but they have a body, and their position an error.
constexpr double POINT_M = 10.0;
constexpr double LINE_M = 10.0;
constexpr double NONE_M = 0.0;

}  // namespace

const std::vector<HazardClass> &hazardCatalogue()
{
    // The radii are those of a point, a line and an area; the last column says whether the class is one of group 1.
    static const std::vector<HazardClass> table = {
        {"ACHARE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"ACHBRT", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"BCNCAR", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BCNISD", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BCNLAT", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BCNSAW", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BCNSPP", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BCNWTW", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BOYCAR", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BOYINB", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BOYISD", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BOYLAT", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BOYSAW", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BOYSPP", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BOYWTW", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"BRIDGE", HazardRule::Overhead, NONE_M, NONE_M, NONE_M, false},
        {"CAUSWY", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"CBLARE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"CBLOHD", HazardRule::Overhead, NONE_M, NONE_M, NONE_M, false},
        {"CBLSUB", HazardRule::Cable, POINT_M, LINE_M, NONE_M, false},
        {"COALNE", HazardRule::Always, POINT_M, NONE_M, NONE_M, false},
        {"CONVYR", HazardRule::Overhead, NONE_M, NONE_M, NONE_M, false},
        {"CRANES", HazardRule::Overhead, NONE_M, NONE_M, NONE_M, false},
        {"CTNARE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"CTSARE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"DAMCON", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"DAYMAR", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"DEPARE", HazardRule::DepthArea, NONE_M, NONE_M, NONE_M, true},
        {"DEPCNT", HazardRule::Ignored, NONE_M, NONE_M, NONE_M, false},
        {"DMPGRD", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"DRGARE", HazardRule::DepthArea, NONE_M, NONE_M, NONE_M, true},
        {"DRYDOC", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"DWRTPT", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"DYKCON", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"FAIRWY", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"FERYRT", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"FLODOC", HazardRule::Always, POINT_M, LINE_M, NONE_M, true},
        {"FORSTC", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"FSHFAC", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"GATCON", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"HRBARE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"HULKES", HazardRule::Always, POINT_M, LINE_M, NONE_M, true},
        {"ICEARE", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"ISTZNE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"LITFLT", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"LITVES", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"LNDARE", HazardRule::Always, POINT_M, LINE_M, NONE_M, true},
        {"LOGPON", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"LOKBSN", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"MARCUL", HazardRule::MarineFarm, POINT_M, LINE_M, NONE_M, false},
        {"MIPARE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"MORFAC", HazardRule::Mooring, POINT_M, LINE_M, NONE_M, false},
        {"M_ACCY", HazardRule::Quality, NONE_M, NONE_M, NONE_M, false},
        {"M_CSCL", HazardRule::Quality, NONE_M, NONE_M, NONE_M, false},
        {"M_QUAL", HazardRule::Quality, NONE_M, NONE_M, NONE_M, false},
        {"M_SDAT", HazardRule::Quality, NONE_M, NONE_M, NONE_M, false},
        {"M_SREL", HazardRule::Quality, NONE_M, NONE_M, NONE_M, false},
        {"M_VDAT", HazardRule::Quality, NONE_M, NONE_M, NONE_M, false},
        {"NEWOBJ", HazardRule::Caution, POINT_M, LINE_M, NONE_M, false},
        {"OBSTRN", HazardRule::Danger, POINT_M, LINE_M, NONE_M, false},
        {"OFSPLF", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"OILBAR", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"OSPARE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"PILPNT", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"PIPARE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"PIPOHD", HazardRule::Overhead, NONE_M, NONE_M, NONE_M, false},
        {"PIPSOL", HazardRule::Pipeline, POINT_M, LINE_M, NONE_M, false},
        {"PONTON", HazardRule::Always, POINT_M, LINE_M, NONE_M, true},
        {"PRCARE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"PYLONS", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"RCRTCL", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"RECTRC", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"RESARE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"SLCONS", HazardRule::Always, POINT_M, LINE_M, NONE_M, false},
        {"SNDWAV", HazardRule::Caution, NONE_M, NONE_M, NONE_M, false},
        {"SOUNDG", HazardRule::Sounding, POINT_M, NONE_M, NONE_M, false},
        {"SPLARE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"SUBTLN", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"SWPARE", HazardRule::Ignored, NONE_M, NONE_M, NONE_M, false},
        {"TSELNE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"TSEZNE", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"TSSBND", HazardRule::Ignored, NONE_M, NONE_M, NONE_M, false},
        {"TSSCRS", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"TSSLPT", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"TSSRON", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"TUNNEL", HazardRule::Ignored, NONE_M, NONE_M, NONE_M, false},
        {"TWRTPT", HazardRule::Regulation, NONE_M, NONE_M, NONE_M, false},
        {"UNSARE", HazardRule::Always, POINT_M, LINE_M, NONE_M, true},
        {"UWTROC", HazardRule::Danger, POINT_M, LINE_M, NONE_M, false},
        {"WATTUR", HazardRule::Caution, NONE_M, NONE_M, NONE_M, false},
        {"WEDKLP", HazardRule::Caution, NONE_M, NONE_M, NONE_M, false},
        {"WRECKS", HazardRule::Danger, POINT_M, LINE_M, NONE_M, false},
    };
    return table;
}

const HazardClass *findHazardClass(const std::string &acronym)
{
    const std::vector<HazardClass> &table = hazardCatalogue();
    const auto found =
        std::lower_bound(table.begin(), table.end(), acronym,
                         [](const HazardClass &row, const std::string &key) { return row.acronym < key; });
    return found != table.end() && found->acronym == acronym ? &*found : nullptr;
}

const std::vector<const char *> &keptAttributes()
{
    static const std::vector<const char *> table = {
        "CATBRG", "CATMOR", "CATOBS", "CATREA", "CATSLC", "CATWRK", "CATZOC", "CONDTN", "DEPTH",  "DRVAL1", "DRVAL2",
        "EXPSOU", "HEIGHT", "HORCLR", "ICEFAC", "ORIENT", "POSACC", "QUAPOS", "QUASOU", "RESTRN", "SOUACC", "STATUS",
        "TRAFIC", "VALSOU", "VERCCL", "VERCLR", "VERCOP", "VERCSA", "VERDAT", "VERLEN", "WATLEV",
    };
    return table;
}

}  // namespace seahex
