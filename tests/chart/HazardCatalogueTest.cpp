#include "seahex/chart/HazardCatalogue.h"

#include <gtest/gtest.h>

#include <cpl_conv.h>
#include <cpl_csv.h>
#include <cpl_string.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

using namespace seahex;

namespace
{

void expectRule(const std::string &acronyms, HazardRule rule)
{
    std::istringstream list(acronyms);
    for (std::string acronym; list >> acronym;)
    {
        const HazardClass *row = findHazardClass(acronym);
        ASSERT_NE(row, nullptr) << acronym;
        EXPECT_EQ(row->rule, rule) << acronym;
    }
}

TEST(HazardCatalogue, isSortedWithoutRepetition)
{
    const auto &table = hazardCatalogue();
    for (std::size_t i = 1; i < table.size(); ++i)
        EXPECT_LT(std::string(table[i - 1].acronym), table[i].acronym);
}

TEST(HazardCatalogue, findsEveryRowAndNothingElse)
{
    for (const HazardClass &row : hazardCatalogue())
        EXPECT_EQ(findHazardClass(row.acronym), &row);
    for (const char *other : {"", "AAAAAA", "ZZZZZZ", "LNDAR", "lndare", "M_COVR", "LIGHTS"})
        EXPECT_EQ(findHazardClass(other), nullptr) << other;
}

TEST(HazardCatalogue, holdsTheClassesOfEveryRule)
{
    expectRule(
        "LNDARE UNSARE PONTON HULKES FLODOC COALNE OILBAR LOGPON SLCONS PILPNT PYLONS OFSPLF FSHFAC FORSTC CAUSWY "
        "DAMCON DYKCON GATCON DRYDOC LOKBSN LITFLT LITVES DAYMAR ICEARE",
        HazardRule::Always);
    expectRule("DEPARE DRGARE", HazardRule::DepthArea);
    expectRule("SOUNDG", HazardRule::Sounding);
    expectRule("OBSTRN UWTROC WRECKS", HazardRule::Danger);
    expectRule("MARCUL", HazardRule::MarineFarm);
    expectRule("MORFAC", HazardRule::Mooring);
    expectRule("PIPSOL", HazardRule::Pipeline);
    expectRule("WATTUR SNDWAV WEDKLP NEWOBJ", HazardRule::Caution);
    expectRule("BRIDGE CBLOHD PIPOHD CONVYR CRANES", HazardRule::Overhead);
    expectRule(
        "RESARE ACHARE DMPGRD MIPARE OSPARE PRCARE ISTZNE CBLARE PIPARE FAIRWY TSSLPT TSEZNE TSELNE TSSRON TSSCRS "
        "CTNARE SPLARE SUBTLN FERYRT HRBARE CTSARE ACHBRT DWRTPT TWRTPT RECTRC RCRTCL",
        HazardRule::Regulation);
    expectRule("M_QUAL M_ACCY M_SREL", HazardRule::Quality);
    expectRule("CBLSUB", HazardRule::Cable);
    expectRule("SWPARE DEPCNT TUNNEL TSSBND", HazardRule::Ignored);
}

TEST(HazardCatalogue, holdsEveryBuoyAndBeaconOfS57)
{
    const char *path = CPLFindFile("gdal", "s57objectclasses.csv");
    if (path == nullptr)
        GTEST_SKIP() << "GDAL's table of S-57 classes is not installed";
    VSILFILE *file = VSIFOpenL(path, "r");
    ASSERT_NE(file, nullptr);
    int marks = 0;
    while (char **line = CSVReadParseLineL(file))
    {
        const CPLStringList fields(line);
        if (fields.size() < 3)
            continue;
        const std::string acronym = fields[2];
        if (acronym.size() != 6 || (acronym.rfind("BOY", 0) != 0 && acronym.rfind("BCN", 0) != 0))
            continue;
        ++marks;
        const HazardClass *row = findHazardClass(acronym);
        ASSERT_NE(row, nullptr) << acronym;
        EXPECT_EQ(row->rule, HazardRule::Always) << acronym;
        EXPECT_DOUBLE_EQ(row->pointRadiusM, 10.0) << acronym;
    }
    VSIFCloseL(file);
    EXPECT_GE(marks, 11);
}

TEST(HazardCatalogue, marksTheSevenClassesOfGroupOne)
{
    std::set<std::string> groupOne;
    for (const HazardClass &row : hazardCatalogue())
        if (row.groupOne)
            groupOne.insert(row.acronym);
    EXPECT_EQ(groupOne, (std::set<std::string>{"DEPARE", "DRGARE", "LNDARE", "UNSARE", "PONTON", "FLODOC", "HULKES"}));
}

TEST(HazardCatalogue, givesPointsARadiusAndAreasNone)
{
    for (const char *acronym : {"UWTROC", "WRECKS", "OBSTRN", "SOUNDG", "PILPNT", "LNDARE", "SLCONS", "MORFAC"})
        EXPECT_DOUBLE_EQ(findHazardClass(acronym)->pointRadiusM, 10.0) << acronym;
    EXPECT_DOUBLE_EQ(findHazardClass("SLCONS")->lineRadiusM, 10.0);
    EXPECT_DOUBLE_EQ(findHazardClass("COALNE")->lineRadiusM, 0.0);
    for (const HazardClass &row : hazardCatalogue())
        EXPECT_DOUBLE_EQ(row.areaRadiusM, 0.0) << row.acronym;
}

TEST(HazardCatalogue, keepsWhatTheRulesAskFor)
{
    const auto &kept = keptAttributes();
    for (const std::string asked :
         {"DRVAL1", "VALSOU", "DEPTH", "WATLEV", "EXPSOU", "CATOBS", "CATWRK", "CATMOR", "QUASOU"})
        EXPECT_TRUE(std::any_of(kept.begin(), kept.end(), [&](const char *name) { return asked == name; })) << asked;
}

}  // namespace
