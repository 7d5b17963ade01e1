#include "seahex/world/BlockingRule.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

using namespace seahex;

namespace
{

constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

/// Needs exactly 2 m, a sum without rounding.
Vessel vesselOfTwoMetres()
{
    Vessel vessel;
    vessel.draughtM = 1.5;
    vessel.underKeelClearanceM = 0.5;
    return vessel;
}

HazardObject object(const std::string &objectClass, HazardRule rule, std::vector<HazardAttribute> attributes = {})
{
    HazardObject made;
    made.objectClass = objectClass;
    made.rule = rule;
    made.cell = "TEST";
    made.featureId = "1";
    made.attributes = std::move(attributes);
    return made;
}

struct Case
{
    std::string label;
    HazardObject object;
    Outcome outcome;
    double depthM;  ///< the depth that must have been tested; NONE where none is
};

void PrintTo(const Case &sample, std::ostream *out)
{
    *out << sample.label;
}

class BlockingRuleTable : public testing::TestWithParam<Case>
{
};

TEST_P(BlockingRuleTable, givesOutcomeAndTestedDepth)
{
    const Verdict verdict = judge(GetParam().object, vesselOfTwoMetres());
    EXPECT_EQ(verdict.outcome, GetParam().outcome) << explain(GetParam().object, vesselOfTwoMetres(), verdict);
    EXPECT_EQ(verdict.depthM.has_value(), !std::isnan(GetParam().depthM));
    if (verdict.depthM && !std::isnan(GetParam().depthM))
    {
        EXPECT_DOUBLE_EQ(*verdict.depthM, GetParam().depthM);
    }
    EXPECT_STRNE(verdict.because, "");
}

std::string nameOf(const testing::TestParamInfo<Case> &info)
{
    std::string name = std::to_string(info.index) + "_";
    for (char letter : info.param.label)
        name += std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
    return name;
}

Case depthArea(const std::string &label, std::vector<HazardAttribute> attributes, Outcome outcome, double depthM)
{
    return {label, object("DEPARE", HazardRule::DepthArea, std::move(attributes)), outcome, depthM};
}

Case danger(const std::string &label, const std::string &objectClass, std::vector<HazardAttribute> attributes,
            Outcome outcome, double depthM, std::optional<double> surroundingDepthM = std::nullopt)
{
    Case made{label, object(objectClass, HazardRule::Danger, std::move(attributes)), outcome, depthM};
    made.object.surroundingDepthM = surroundingDepthM;
    return made;
}

const double JUST_DEEPER = std::nextafter(2.0, 3.0);
const double JUST_SHOALER = std::nextafter(2.0, 1.0);

INSTANTIATE_TEST_SUITE_P(
    Areas, BlockingRuleTable,
    testing::Values(depthArea("shoaler", {{"DRVAL1", {JUST_SHOALER}}}, Outcome::Blocked, JUST_SHOALER),
                    depthArea("equal is enough", {{"DRVAL1", {2.0}}}, Outcome::Ignored, 2.0),
                    depthArea("unknown DRVAL1", {}, Outcome::Blocked, -1.0),
                    depthArea("unknown DRVAL1 with DRVAL2", {{"DRVAL2", {30.0}}}, Outcome::Blocked, -1.0),
                    depthArea("ambiguous DRVAL1", {{"DRVAL1", {2.0, 5.0}}}, Outcome::Blocked, -1.0),
                    depthArea("not maintained", {{"DRVAL1", {5.0}}, {"QUASOU", {6.0, 11.0}}}, Outcome::Cost, 5.0),
                    depthArea("not maintained and shoal", {{"DRVAL1", {1.0}}, {"QUASOU", {11.0}}}, Outcome::Blocked,
                              1.0)),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Soundings, BlockingRuleTable,
    testing::Values(Case{"shoal", object("SOUNDG", HazardRule::Sounding, {{"DEPTH", {0.4}}}), Outcome::Blocked, 0.4},
                    Case{"equal blocks", object("SOUNDG", HazardRule::Sounding, {{"DEPTH", {2.0}}}), Outcome::Blocked,
                         2.0},
                    Case{"deeper", object("SOUNDG", HazardRule::Sounding, {{"DEPTH", {JUST_DEEPER}}}), Outcome::Ignored,
                         JUST_DEEPER},
                    Case{"unknown", object("SOUNDG", HazardRule::Sounding), Outcome::Blocked, NONE}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    KnownDepthOfDangers, BlockingRuleTable,
    testing::Values(danger("equal blocks", "UWTROC", {{"VALSOU", {2.0}}}, Outcome::Blocked, 2.0),
                    danger("deeper costs", "WRECKS", {{"VALSOU", {JUST_DEEPER}}}, Outcome::Cost, JUST_DEEPER),
                    danger("negative", "OBSTRN", {{"VALSOU", {-0.8}}}, Outcome::Blocked, -0.8),
                    danger("VALSOU beats CATWRK", "WRECKS", {{"VALSOU", {9.0}}, {"CATWRK", {2.0}}}, Outcome::Cost, 9.0),
                    danger("VALSOU beats WATLEV 4", "UWTROC", {{"VALSOU", {9.0}}, {"WATLEV", {4.0}}}, Outcome::Cost,
                           9.0),
                    danger("VALSOU beats surroundings", "UWTROC",
                           {{"VALSOU", {1.0}}, {"WATLEV", {3.0}}, {"EXPSOU", {1.0}}}, Outcome::Blocked, 1.0, 20.0),
                    danger("floating", "OBSTRN", {{"VALSOU", {9.0}}, {"WATLEV", {7.0}}}, Outcome::Blocked, NONE),
                    danger("ice boom", "OBSTRN", {{"VALSOU", {9.0}}, {"CATOBS", {8.0}}}, Outcome::Blocked, NONE),
                    danger("boom", "OBSTRN", {{"VALSOU", {9.0}}, {"CATOBS", {10.0}}}, Outcome::Blocked, NONE)),
    nameOf);

/// Missing VALSOU, step by step; each step with a case that the step before must not catch.
INSTANTIATE_TEST_SUITE_P(
    MissingValsou, BlockingRuleTable,
    testing::Values(
        // 1: depth of the surroundings
        danger("1 within range", "UWTROC", {{"WATLEV", {3.0}}, {"EXPSOU", {1.0}}}, Outcome::Cost, 5.0, 5.0),
        danger("1 deeper than range", "WRECKS", {{"WATLEV", {3.0}}, {"EXPSOU", {3.0}}}, Outcome::Cost, 5.0, 5.0),
        danger("1 shoal surroundings", "OBSTRN", {{"WATLEV", {3.0}}, {"EXPSOU", {1.0}}}, Outcome::Blocked, 2.0, 2.0),
        danger("1 comes before foul area", "OBSTRN", {{"WATLEV", {3.0}}, {"EXPSOU", {1.0}}, {"CATOBS", {6.0}}},
               Outcome::Cost, 5.0, 5.0),
        danger("not 1 shoaler than range", "UWTROC", {{"WATLEV", {3.0}}, {"EXPSOU", {2.0}}}, Outcome::Blocked, 0.01,
               5.0),
        danger("not 1 EXPSOU unknown", "UWTROC", {{"WATLEV", {3.0}}}, Outcome::Blocked, 0.01, 5.0),
        danger("not 1 WATLEV 4", "UWTROC", {{"WATLEV", {4.0}}, {"EXPSOU", {1.0}}}, Outcome::Blocked, -15.0, 5.0),
        danger("not 1 no surroundings", "UWTROC", {{"WATLEV", {3.0}}, {"EXPSOU", {1.0}}}, Outcome::Blocked, 0.01),
        // 2: foul area
        danger("2 foul area", "OBSTRN", {{"CATOBS", {6.0}}, {"WATLEV", {4.0}}}, Outcome::Blocked, 0.01, 30.0),
        // 2a: wrecks
        danger("2a non dangerous in deep water", "WRECKS", {{"CATWRK", {1.0}}}, Outcome::Cost, 20.0, 2.0),
        danger("2a non dangerous in shoal water", "WRECKS", {{"CATWRK", {1.0}}, {"WATLEV", {3.0}}}, Outcome::Blocked,
               0.01, JUST_SHOALER),
        danger("2a non dangerous somewhere", "WRECKS", {{"CATWRK", {1.0}}, {"WATLEV", {5.0}}}, Outcome::Blocked, 0.0),
        danger("2a dangerous", "WRECKS", {{"CATWRK", {2.0}}, {"WATLEV", {3.0}}}, Outcome::Blocked, 0.0, 30.0),
        danger("2a mast", "WRECKS", {{"CATWRK", {4.0}}, {"WATLEV", {3.0}}}, Outcome::Blocked, -15.0, 30.0),
        danger("2a hull", "WRECKS", {{"CATWRK", {5.0}}, {"WATLEV", {5.0}}}, Outcome::Blocked, -15.0, 30.0),
        danger("2a distributed remains go on", "WRECKS", {{"CATWRK", {3.0}}, {"WATLEV", {3.0}}}, Outcome::Blocked, 0.01,
               30.0),
        danger("2a is for wrecks alone", "OBSTRN", {{"CATWRK", {1.0}}, {"WATLEV", {3.0}}}, Outcome::Blocked, 0.01,
               30.0),
        // 3 to 5: WATLEV
        danger("3 awash", "UWTROC", {{"WATLEV", {5.0}}}, Outcome::Blocked, 0.0),
        danger("4 always under water", "UWTROC", {{"WATLEV", {3.0}}}, Outcome::Blocked, 0.01),
        danger("5 WATLEV 1", "OBSTRN", {{"WATLEV", {1.0}}}, Outcome::Blocked, -15.0),
        danger("5 WATLEV 2", "WRECKS", {{"WATLEV", {2.0}}}, Outcome::Blocked, -15.0),
        danger("5 WATLEV 4", "UWTROC", {{"WATLEV", {4.0}}}, Outcome::Blocked, -15.0),
        danger("5 WATLEV 6", "OBSTRN", {{"WATLEV", {6.0}}}, Outcome::Blocked, -15.0),
        danger("5 WATLEV of another code", "OBSTRN", {{"WATLEV", {99.0}}}, Outcome::Blocked, -15.0),
        danger("5 nothing known", "UWTROC", {}, Outcome::Blocked, -15.0)),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    FoulGround, BlockingRuleTable,
    testing::Values(danger("no attributes", "OBSTRN", {{"CATOBS", {7.0}}}, Outcome::Cost, NONE),
                    danger("under water", "OBSTRN", {{"CATOBS", {7.0}}, {"WATLEV", {3.0}}}, Outcome::Cost, NONE),
                    danger("awash", "OBSTRN", {{"CATOBS", {7.0}}, {"WATLEV", {5.0}}}, Outcome::Blocked, 0.0),
                    danger("covers", "OBSTRN", {{"CATOBS", {7.0}}, {"WATLEV", {4.0}}}, Outcome::Blocked, -15.0),
                    danger("floods", "OBSTRN", {{"CATOBS", {7.0}}, {"WATLEV", {6.0}}}, Outcome::Blocked, -15.0),
                    danger("floats", "OBSTRN", {{"CATOBS", {7.0}}, {"WATLEV", {7.0}}}, Outcome::Blocked, NONE),
                    danger("shoal", "OBSTRN", {{"CATOBS", {7.0}}, {"VALSOU", {1.0}}}, Outcome::Blocked, 1.0)),
    nameOf);

Case simple(const std::string &objectClass, HazardRule rule, std::vector<HazardAttribute> attributes, Outcome outcome,
            double depthM = NONE)
{
    std::string label = objectClass;
    for (const HazardAttribute &attribute : attributes)
        label += " " + attribute.acronym + " " + std::to_string(attribute.values.front());
    return {label, object(objectClass, rule, std::move(attributes)), outcome, depthM};
}

INSTANTIATE_TEST_SUITE_P(
    OtherRules, BlockingRuleTable,
    testing::Values(
        simple("LNDARE", HazardRule::Always, {}, Outcome::Blocked),
        simple("UNSARE", HazardRule::Always, {}, Outcome::Blocked),
        simple("FLODOC", HazardRule::Always, {{"DRVAL1", {9.0}}}, Outcome::Blocked),
        simple("M_COVR", HazardRule::ChartGap, {}, Outcome::Blocked),
        simple("MARCUL", HazardRule::MarineFarm, {}, Outcome::Blocked),
        simple("MARCUL", HazardRule::MarineFarm, {{"VALSOU", {9.0}}}, Outcome::Blocked),
        simple("MARCUL", HazardRule::MarineFarm, {{"WATLEV", {3.0}}}, Outcome::Blocked),
        simple("MARCUL", HazardRule::MarineFarm, {{"VALSOU", {9.0}}, {"WATLEV", {4.0}}}, Outcome::Blocked),
        simple("MARCUL", HazardRule::MarineFarm, {{"VALSOU", {2.0}}, {"WATLEV", {3.0}}}, Outcome::Blocked, 2.0),
        simple("MARCUL", HazardRule::MarineFarm, {{"VALSOU", {9.0}}, {"WATLEV", {3.0}}}, Outcome::Cost, 9.0),
        simple("MORFAC", HazardRule::Mooring, {}, Outcome::Blocked),
        simple("MORFAC", HazardRule::Mooring, {{"CATMOR", {1.0}}}, Outcome::Blocked),
        simple("MORFAC", HazardRule::Mooring, {{"CATMOR", {2.0}}}, Outcome::Blocked),
        simple("MORFAC", HazardRule::Mooring, {{"CATMOR", {3.0}}}, Outcome::Blocked),
        simple("MORFAC", HazardRule::Mooring, {{"CATMOR", {4.0}}}, Outcome::Blocked),
        simple("MORFAC", HazardRule::Mooring, {{"CATMOR", {5.0}}}, Outcome::Blocked),
        simple("MORFAC", HazardRule::Mooring, {{"CATMOR", {6.0}}}, Outcome::Cost),
        simple("MORFAC", HazardRule::Mooring, {{"CATMOR", {7.0}}}, Outcome::Blocked),
        simple("MORFAC", HazardRule::Mooring, {{"CATMOR", {42.0}}}, Outcome::Blocked),
        simple("PIPSOL", HazardRule::Pipeline, {}, Outcome::Ignored),
        simple("PIPSOL", HazardRule::Pipeline, {{"DRVAL1", {2.0}}}, Outcome::Blocked, 2.0),
        simple("PIPSOL", HazardRule::Pipeline, {{"DRVAL1", {JUST_DEEPER}}}, Outcome::Ignored, JUST_DEEPER),
        simple("WATTUR", HazardRule::Caution, {}, Outcome::Cost),
        simple("NEWOBJ", HazardRule::Caution, {}, Outcome::Cost),
        simple("NEWOBJ", HazardRule::Caution, {{"WATLEV", {3}}}, Outcome::Cost),
        simple("NEWOBJ", HazardRule::Caution, {{"WATLEV", {2}}}, Outcome::Blocked),
        simple("NEWOBJ", HazardRule::Caution, {{"WATLEV", {7}}}, Outcome::Blocked),
        simple("BRIDGE", HazardRule::Overhead, {}, Outcome::Cost),
        simple("RESARE", HazardRule::Regulation, {}, Outcome::Cost),
        simple("M_QUAL", HazardRule::Quality, {}, Outcome::Cost),
        simple("SWPARE", HazardRule::Ignored, {{"DRVAL1", {0.1}}}, Outcome::Ignored)),
    nameOf);

const HazardRule RULES_WITH_DEPTH[] = {HazardRule::DepthArea, HazardRule::Sounding, HazardRule::Danger,
                                       HazardRule::Pipeline, HazardRule::MarineFarm};

TEST(BlockingRule, blocksWhereADepthIsNoNumber)
{
    for (double depthM : {NONE, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
        for (HazardRule rule : RULES_WITH_DEPTH)
        {
            const HazardObject odd =
                object("X", rule, {{"DRVAL1", {depthM}}, {"DEPTH", {depthM}}, {"VALSOU", {depthM}}, {"WATLEV", {3.0}}});
            EXPECT_TRUE(judge(odd, vesselOfTwoMetres()).blocks()) << static_cast<int>(rule) << " at " << depthM;
        }
}

TEST(BlockingRule, blocksWhereTheVesselsDepthIsNoNumber)
{
    Vessel vessel;
    vessel.draughtM = NONE;
    for (HazardRule rule : RULES_WITH_DEPTH)
    {
        const HazardObject deep =
            object("X", rule, {{"DRVAL1", {99.0}}, {"DEPTH", {99.0}}, {"VALSOU", {99.0}}, {"WATLEV", {3.0}}});
        EXPECT_TRUE(judge(deep, vessel).blocks()) << static_cast<int>(rule);
        EXPECT_FALSE(judge(deep, Vessel{}).blocks()) << static_cast<int>(rule);
    }
}

TEST(BlockingRule, countsLandAloneInTheLandOnlyScope)
{
    EXPECT_TRUE(judge(object("LNDARE", HazardRule::Always), {}, HazardScope::LandOnly).blocks());
    for (const char *other : {"UNSARE", "DEPARE", "WRECKS", "SLCONS", "M_COVR"})
        EXPECT_EQ(judge(object(other, HazardRule::Always), {}, HazardScope::LandOnly).outcome, Outcome::Ignored)
            << other;
}

TEST(BlockingRule, keepsOutOfEverythingInTheWaterColumnButNotOfDepths)
{
    const auto underWater = [](const char *objectClass, HazardRule rule, HazardScope scope = HazardScope::WaterColumn)
    {
        const HazardObject deep = object(objectClass, rule,
                                         {{"DRVAL1", {900.0}},
                                          {"DEPTH", {900.0}},
                                          {"VALSOU", {900.0}},
                                          {"WATLEV", {3.0}},
                                          {"CATMOR", {6.0}},
                                          {"CATOBS", {7.0}}});
        return judge(deep, {}, scope).outcome;
    };
    EXPECT_EQ(underWater("DEPARE", HazardRule::DepthArea), Outcome::Ignored);
    EXPECT_EQ(judge(object("DEPARE", HazardRule::DepthArea), {}, HazardScope::WaterColumn).outcome, Outcome::Ignored);
    EXPECT_EQ(underWater("SOUNDG", HazardRule::Sounding), Outcome::Ignored);
    for (const HazardRule rule : {HazardRule::Always, HazardRule::Danger, HazardRule::MarineFarm, HazardRule::Mooring,
                                  HazardRule::Pipeline, HazardRule::Cable, HazardRule::ChartGap})
    {
        EXPECT_EQ(underWater("X", rule), Outcome::Blocked) << static_cast<int>(rule);
        EXPECT_EQ(underWater("X", rule, HazardScope::WaterColumnAboveCables),
                  rule == HazardRule::Cable ? Outcome::Cost : Outcome::Blocked)
            << static_cast<int>(rule);
    }
    EXPECT_EQ(underWater("DEPARE", HazardRule::DepthArea, HazardScope::WaterColumnAboveCables), Outcome::Ignored);
    EXPECT_EQ(underWater("RESARE", HazardRule::Regulation), Outcome::Cost);
    EXPECT_EQ(judge(object("CBLSUB", HazardRule::Cable), {}).outcome, Outcome::Ignored) << "no matter at the surface";
}

RC_GTEST_PROP(BlockingRule, neverOpensForADeeperVesselWhatIsShutForAShallowOne, ())
{
    const auto someDepth = rc::gen::map(rc::gen::inRange(-40, 400), [](int dm) { return 0.1 * dm; });
    HazardObject sample =
        object("WRECKS",
               *rc::gen::elementOf(std::vector<HazardRule>(std::begin(RULES_WITH_DEPTH), std::end(RULES_WITH_DEPTH))));
    for (const char *acronym : {"DRVAL1", "VALSOU", "DEPTH"})
        if (*rc::gen::arbitrary<bool>())
            sample.attributes.push_back({acronym, {*someDepth}});
    for (const char *acronym : {"WATLEV", "EXPSOU", "CATWRK", "CATOBS"})
        if (*rc::gen::arbitrary<bool>())
            sample.attributes.push_back({acronym, {static_cast<double>(*rc::gen::inRange(1, 12))}});
    if (*rc::gen::arbitrary<bool>())
        sample.surroundingDepthM = *someDepth;

    Vessel shallow;
    shallow.draughtM = 0.1 * *rc::gen::inRange(1, 300);
    Vessel deep = shallow;
    deep.draughtM += 0.1 * *rc::gen::inRange(0, 200);
    if (judge(sample, shallow).blocks())
        RC_ASSERT(judge(sample, deep).blocks());
}

TEST(BlockingRule, keepsTheLargerOfMarginAndRadius)
{
    HazardObject rock = object("UWTROC", HazardRule::Danger);
    rock.radiusM = 10.0;
    Vessel vessel;
    vessel.marginM = 4.0;
    EXPECT_DOUBLE_EQ(keepOutRadiusM(rock, vessel), 10.0);
    vessel.marginM = 25.0;
    EXPECT_DOUBLE_EQ(keepOutRadiusM(rock, vessel), 25.0);
}

TEST(BlockingRule, explainsWithObjectDepthAndNeed)
{
    const HazardObject wreck = object("WRECKS", HazardRule::Danger, {{"VALSOU", {0.4}}});
    EXPECT_EQ(explain(wreck, Vessel{}, judge(wreck, Vessel{})),
              "WRECKS 1 of TEST (VALSOU 0.4): depth 0.4 m, 1.7 m needed (least depth of the danger)");
    const HazardObject land = object("LNDARE", HazardRule::Always);
    EXPECT_EQ(explain(land, Vessel{}, judge(land, Vessel{})), "LNDARE 1 of TEST: land");
}

TEST(HazardObject, knowsSingleValuesAndLists)
{
    const HazardObject area = object("RESARE", HazardRule::Regulation, {{"RESTRN", {7.0, 14.0}}, {"CATREA", {9.0}}});
    EXPECT_EQ(area.value("CATREA"), 9.0);
    EXPECT_EQ(area.value("RESTRN"), std::nullopt);
    EXPECT_EQ(area.value("VALSOU"), std::nullopt);
    EXPECT_TRUE(area.has("RESTRN", 14));
    EXPECT_FALSE(area.has("RESTRN", 1));
    EXPECT_FALSE(area.has("VALSOU", 0));
}

TEST(HazardObject, isDescribedAsAPersonWouldLookItUp)
{
    HazardObject wreck =
        object("WRECKS", HazardRule::Danger, {{"VALSOU", {3.6}}, {"WATLEV", {3.0}}, {"QUASOU", {6, 7}}});
    wreck.featureId = "022604B5D1B20DBE";
    wreck.cell = "US5MA12M";
    EXPECT_EQ(describe(wreck), "WRECKS 022604B5D1B20DBE of US5MA12M (VALSOU 3.6, WATLEV 3, QUASOU 6/7)");
    wreck.name = "Mary Ann";
    wreck.attributes.clear();
    EXPECT_EQ(describe(wreck), "WRECKS 022604B5D1B20DBE \"Mary Ann\" of US5MA12M");
}

}  // namespace
