#include "support/ChartOracle.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <random>
#include <set>

#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

using namespace seahex::test;

namespace
{

const OracleVessel vessel{1.2, 0.5};

using Attributes = std::map<std::string, std::string>;

/// A GeoPackage in memory whose layers bear S-57 acronyms.
class TinyChart
{
public:
    void add(const std::string &layer, const std::string &wkt, const Attributes &attributes = {})
    {
        objects_[layer].push_back({wkt, attributes});
    }

    /// One degree square of 10 m of water from (0, south), in two areas and two coverages with a seam at longitude 0.5.
    static TinyChart ofDeepWater(double south = 0.0)
    {
        TinyChart chart;
        for (const double west : {0.0, 0.5})
        {
            chart.add("M_COVR", box(west, south, west + 0.5, south + 1.0), {{"CATCOV", "1"}});
            chart.add("DEPARE", box(west, south, west + 0.5, south + 1.0), {{"DRVAL1", "10"}, {"DRVAL2", "20"}});
        }
        return chart;
    }

    static std::string box(double west, double south, double east, double north)
    {
        return "POLYGON((" + at(west, south) + "," + at(east, south) + "," + at(east, north) + "," + at(west, north) +
               "," + at(west, south) + "))";
    }

    static std::string at(double x, double y)
    {
        std::array<char, 64> written{};
        std::snprintf(written.data(), written.size(), "%.17g %.17g", x, y);
        return written.data();
    }

    ChartOracle judged(const OracleVessel &ship = vessel, int epsg = 4326, bool allText = false) const
    {
        GDALAllRegister();
        const std::string path = "/vsimem/chart_oracle_test.gpkg";
        auto *driver = GetGDALDriverManager()->GetDriverByName("GPKG");
        GDALDatasetUniquePtr dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        OGRSpatialReference frame;
        frame.importFromEPSG(epsg);
        for (const auto &[name, objects] : objects_)
            write(*dataset->CreateLayer(name.c_str(), &frame, wkbUnknown, nullptr), objects, allText);
        dataset.reset();
        const std::unique_ptr<const std::string, void (*)(const std::string *)> remove(
            &path, [](const std::string *file) { VSIUnlink(file->c_str()); });
        return {path, ship};
    }

private:
    struct Object
    {
        std::string wkt;
        Attributes attributes;
    };

    static OGRFieldType typeOf(const std::string &attribute)
    {
        static const std::set<std::string> real = {"DRVAL1", "DRVAL2", "VALSOU", "VALDCO"};
        static const std::set<std::string> written = {"LNAM", "RESTRN", "QUASOU"};
        return real.count(attribute) != 0 ? OFTReal : written.count(attribute) != 0 ? OFTString : OFTInteger;
    }

    static void write(OGRLayer &layer, const std::vector<Object> &objects, bool allText)
    {
        for (const Object &object : objects)
            for (const auto &[name, value] : object.attributes)
                if (layer.GetLayerDefn()->GetFieldIndex(name.c_str()) < 0)
                {
                    OGRFieldDefn field(name.c_str(), allText ? OFTString : typeOf(name));
                    layer.CreateField(&field);
                }
        for (const Object &object : objects)
        {
            OGRFeature feature(layer.GetLayerDefn());
            for (const auto &[name, value] : object.attributes)
                feature.SetField(name.c_str(), value.c_str());
            OGRGeometry *geometry = nullptr;
            ASSERT_EQ(OGRERR_NONE, OGRGeometryFactory::createFromWkt(object.wkt.c_str(), nullptr, &geometry));
            feature.SetGeometryDirectly(geometry);
            ASSERT_EQ(OGRERR_NONE, layer.CreateFeature(&feature));
        }
    }

    std::map<std::string, std::vector<Object>> objects_;
};

std::string listed(const std::vector<Violation> &violations)
{
    std::string all;
    for (const Violation &violation : violations)
        all += violation.what + "\n";
    return all;
}

testing::AssertionResult free(const std::vector<Violation> &violations)
{
    if (violations.empty())
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << listed(violations);
}

testing::AssertionResult says(const std::vector<Violation> &violations, const std::string &words)
{
    if (listed(violations).find(words) != std::string::npos)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "\"" << words << "\" is not in: " << listed(violations);
}

// ---------------------------------------------------------------------------------------------------- the rules

struct Rule
{
    std::string name;
    char shape;  ///< point, line, area, or Z: a point with the depth in its Z
    Attributes attributes;
    std::string verdict;  ///< part of the accusation; empty: does not block
    std::string under{};  ///< "UNSARE", "no DRVAL1" or the DRVAL1 of a depth area under the object
};

std::vector<Rule> rulesOfAttributes()
{
    const std::string shallow = "1";
    return {
        {"DEPARE", 'a', {{"DRVAL1", "1.6"}}, "DRVAL1 1.6 m"},
        {"DEPARE", 'a', {{"DRVAL1", "1.7"}}, ""},
        {"DEPARE", 'a', {{"DRVAL2", "9"}}, "no DRVAL1"},
        {"DEPARE", 'l', {{"DRVAL1", "-1"}}, "DRVAL1 -1 m"},
        {"DRGARE", 'a', {{"DRVAL1", "1.6"}}, "DRVAL1 1.6 m"},
        {"DRGARE", 'a', {{"DRVAL1", "1.7"}}, ""},
        {"DRGARE", 'a', {}, "no DRVAL1"},
        {"SOUNDG", 'z', {{"DRVAL2", "1.7"}}, "1.7 m"},
        {"SOUNDG", 'z', {{"DRVAL2", "1.8"}}, ""},
        {"SOUNDG", 'z', {{"DRVAL2", "-0.3"}}, "-0.3 m"},
        {"FLODOC", 'a', {{"DRVAL1", "10"}}, "always"},
        {"OBSTRN", 'p', {{"VALSOU", "1.7"}}, "VALSOU 1.7 m"},
        {"OBSTRN", 'l', {{"VALSOU", "0.4"}}, "VALSOU 0.4 m"},
        {"OBSTRN", 'a', {{"VALSOU", "1.8"}, {"WATLEV", "4"}}, ""},
        {"OBSTRN", 'a', {{"VALSOU", "30"}, {"WATLEV", "7"}}, "WATLEV 7"},
        {"OBSTRN", 'l', {{"VALSOU", "30"}, {"CATOBS", "8"}}, "CATOBS 8"},
        {"OBSTRN", 'l', {{"VALSOU", "30"}, {"CATOBS", "10"}}, "CATOBS 10"},
        {"OBSTRN", 'a', {{"VALSOU", "30"}, {"CATOBS", "6"}}, ""},
        {"OBSTRN", 'a', {{"CATOBS", "6"}, {"WATLEV", "4"}}, "taken as 0.01 m"},
        {"OBSTRN", 'a', {{"CATOBS", "6"}, {"WATLEV", "3"}, {"EXPSOU", "1"}}, ""},
        {"OBSTRN", 'a', {{"CATOBS", "7"}}, ""},
        {"OBSTRN", 'a', {{"CATOBS", "7"}, {"WATLEV", "3"}}, ""},
        {"OBSTRN", 'a', {{"CATOBS", "7"}, {"WATLEV", "7"}}, "WATLEV 7"},
        {"OBSTRN", 'a', {{"CATOBS", "7"}, {"VALSOU", "1"}}, "VALSOU 1 m"},
        {"OBSTRN", 'a', {{"CATOBS", "7"}, {"WATLEV", "1"}}, "taken as -15 m"},
        {"OBSTRN", 'a', {{"CATOBS", "7"}, {"WATLEV", "2"}}, "taken as -15 m"},
        {"OBSTRN", 'a', {{"CATOBS", "7"}, {"WATLEV", "4"}}, "taken as -15 m"},
        {"OBSTRN", 'a', {{"CATOBS", "7"}, {"WATLEV", "5"}}, "taken as 0 m"},
        {"OBSTRN", 'a', {{"CATOBS", "7"}, {"WATLEV", "6"}}, "taken as -15 m"},
        {"OBSTRN", 'p', {{"WATLEV", "3"}}, "taken as 0.01 m"},
        {"OBSTRN", 'p', {{"WATLEV", "3"}, {"EXPSOU", "1"}}, ""},
        {"OBSTRN", 'p', {{"WATLEV", "3"}, {"EXPSOU", "3"}}, ""},
        {"OBSTRN", 'p', {{"WATLEV", "3"}, {"EXPSOU", "2"}}, "taken as 0.01 m"},
        {"OBSTRN", 'p', {{"WATLEV", "4"}, {"EXPSOU", "1"}}, "taken as -15 m"},
        {"OBSTRN", 'p', {{"WATLEV", "3"}, {"EXPSOU", "1"}}, "taken as 0.01 m", "UNSARE"},
        {"OBSTRN", 'a', {{"WATLEV", "3"}, {"EXPSOU", "1"}}, "taken as 1 m", shallow},
        {"OBSTRN", 'a', {{"WATLEV", "3"}, {"EXPSOU", "1"}}, "taken as -1 m", "no DRVAL1"},
        {"UWTROC", 'p', {{"VALSOU", "1.8"}, {"QUASOU", "7"}}, ""},
        {"UWTROC", 'p', {{"WATLEV", "5"}}, "taken as 0 m"},
        {"UWTROC", 'p', {}, "taken as -15 m"},
        {"WRECKS", 'p', {{"VALSOU", "5"}, {"CATWRK", "2"}}, ""},
        {"WRECKS", 'p', {{"CATWRK", "1"}}, ""},
        {"WRECKS", 'p', {{"CATWRK", "1"}, {"WATLEV", "2"}}, ""},
        {"WRECKS", 'p', {{"CATWRK", "1"}, {"WATLEV", "3"}}, "taken as 0.01 m", "UNSARE"},
        {"WRECKS", 'p', {{"CATWRK", "1"}, {"WATLEV", "3"}}, "taken as 0.01 m", shallow},
        {"WRECKS", 'p', {{"CATWRK", "2"}, {"WATLEV", "3"}}, "taken as 0 m"},
        {"WRECKS", 'p', {{"CATWRK", "2"}, {"WATLEV", "3"}, {"EXPSOU", "1"}}, ""},
        {"WRECKS", 'p', {{"CATWRK", "3"}, {"WATLEV", "3"}}, "taken as 0.01 m"},
        {"WRECKS", 'a', {{"CATWRK", "4"}, {"WATLEV", "3"}}, "taken as -15 m"},
        {"WRECKS", 'p', {{"CATWRK", "5"}, {"WATLEV", "5"}}, "taken as -15 m"},
        {"SLCONS", 'a', {{"WATLEV", "3"}}, "always"},
        {"MORFAC", 'p', {{"CATMOR", "4"}}, ""},
        {"MORFAC", 'p', {{"CATMOR", "6"}}, ""},
        {"MORFAC", 'p', {}, "mooring"},
        {"MARCUL", 'a', {{"WATLEV", "3"}}, "marine farm"},
        {"MARCUL", 'a', {{"VALSOU", "5"}}, "marine farm"},
        {"MARCUL", 'a', {{"VALSOU", "1.7"}, {"WATLEV", "3"}}, "marine farm"},
        {"MARCUL", 'a', {{"VALSOU", "5"}, {"WATLEV", "3"}}, ""},
        {"PIPSOL", 'l', {{"DRVAL1", "1.7"}}, "DRVAL1 1.7 m"},
        {"PIPSOL", 'l', {{"DRVAL1", "1.8"}}, ""},
        {"PIPSOL", 'l', {}, ""},
        {"SWPARE", 'a', {{"DRVAL1", "0.5"}}, ""},
        {"DEPCNT", 'l', {{"VALDCO", "0"}}, ""},
    };
}

std::vector<Rule> allRules()
{
    auto rules = rulesOfAttributes();
    for (const char *code : {"1", "2", "3", "5", "7"})
        rules.push_back({"MORFAC", 'p', {{"CATMOR", code}}, "mooring"});
    for (const char *name : {"LNDARE", "SLCONS", "PYLONS", "OFSPLF", "FSHFAC", "FORSTC", "CAUSWY"})
        for (const char shape : {'p', 'l', 'a'})
            rules.push_back({name, shape, {}, "always"});
    for (const char *name : {"UNSARE", "PONTON", "HULKES", "ICEARE", "DRYDOC", "LOKBSN", "DYKCON"})
        rules.push_back({name, 'a', {}, "always"});
    for (const char *name : {"COALNE", "PONTON", "OILBAR", "LOGPON", "DAMCON", "DYKCON", "GATCON"})
        rules.push_back({name, 'l', {}, "always"});
    for (const char *name : {"BOYCAR", "BOYINB", "BOYISD", "BOYLAT", "BOYSAW", "BOYSPP", "BCNCAR", "BCNISD", "BCNLAT",
                             "BCNSAW", "BCNSPP", "LITFLT", "LITVES", "DAYMAR", "PILPNT"})
        rules.push_back({name, 'p', {}, "always"});
    for (const char *name : {"BRIDGE", "RESARE", "CBLSUB", "TSEZNE", "SBDARE"})
        rules.push_back({name, 'a', {}, ""});
    for (const char *name : {"LIGHTS", "TOPMAR", "NEWOBJ", "LNDMRK"})
        rules.push_back({name, 'p', {}, ""});
    return rules;
}

std::string drawn(const Rule &rule, double x, double y, double reach)
{
    if (rule.shape == 'p')
        return "POINT(" + TinyChart::at(x, y) + ")";
    if (rule.shape == 'z')
        return "POINT Z(" + TinyChart::at(x, y) + " " + rule.attributes.at("DRVAL2") + ")";
    if (rule.shape == 'l')
        return "LINESTRING(" + TinyChart::at(x, y - reach) + "," + TinyChart::at(x, y + reach) + ")";
    return TinyChart::box(x - reach, y - reach, x + reach, y + reach);
}

TEST(ChartOracle, everyRuleBlocksOrSparesItsObject)
{
    // Each rule has a cell of its own, 1/16 of a degree wide, on the same deep water.
    const auto rules = allRules();
    const double cell = 1.0 / 16.0;
    const auto centre = [&](std::size_t i)
    {
        return LatLon{(std::floor(static_cast<double>(i) / 16.0) + 0.5) * cell,
                      (static_cast<double>(i % 16) + 0.5) * cell};
    };
    auto chart = TinyChart::ofDeepWater();
    ASSERT_LE(rules.size(), 16U * 15U);
    for (std::size_t i = 0; i < rules.size(); ++i)
    {
        const auto [y, x] = centre(i);
        chart.add(rules[i].name, drawn(rules[i], x, y, cell / 4), rules[i].attributes);
        const std::string around = TinyChart::box(x - cell / 3, y - cell / 3, x + cell / 3, y + cell / 3);
        if (rules[i].under == "UNSARE")
            chart.add("UNSARE", around);
        else if (rules[i].under == "no DRVAL1")
            chart.add("DEPARE", around);
        else if (!rules[i].under.empty())
            chart.add("DEPARE", around, {{"DRVAL1", rules[i].under}});
    }
    const ChartOracle oracle = chart.judged();
    for (std::size_t i = 0; i < rules.size(); ++i)
    {
        const Rule &rule = rules[i];
        const auto [y, x] = centre(i);
        SCOPED_TRACE("rule " + std::to_string(i) + ": " + rule.name + " " + rule.shape + " " + rule.verdict);
        const auto across = oracle.violations({{y, x - 0.45 * cell}, {y, x + 0.45 * cell}});
        const auto beside = oracle.violations({{y - 0.4 * cell, x - 0.45 * cell}, {y - 0.4 * cell, x + 0.45 * cell}});
        EXPECT_TRUE(free(beside));
        EXPECT_EQ(across.size(), (rule.verdict.empty() ? 0U : 1U) + (rule.under.empty() ? 0U : 1U)) << listed(across);
        if (!rule.verdict.empty())
        {
            EXPECT_TRUE(says(across, "leg 0 touches " + rule.name));
            EXPECT_TRUE(says(across, rule.verdict));
        }
        EXPECT_EQ(oracle.blocked(y, x), !across.empty());
    }
}

TEST(ChartOracle, depthsMeetAsWrittenNotAsDoubles)
{
    auto chart = TinyChart::ofDeepWater();
    chart.add("OBSTRN", "POINT(0.25 0.25)", {{"VALSOU", "0.8"}});
    chart.add("DEPARE", TinyChart::box(0.7, 0.2, 0.8, 0.3), {{"DRVAL1", "3.3"}});
    EXPECT_LT(0.1 + 0.7, 0.8) << "the sum of doubles falls short";
    EXPECT_TRUE(chart.judged({0.1, 0.7}).blocked(0.25, 0.25));
    EXPECT_GT(1.1 + 2.2, 3.3) << "the sum of doubles exceeds";
    EXPECT_FALSE(chart.judged({1.1, 2.2}).blocked(0.25, 0.75));
}

TEST(ChartOracle, readsAttributesThatASourceStoresAsText)
{
    auto chart = TinyChart::ofDeepWater();
    chart.add("OBSTRN", "POINT(0.25 0.25)", {{"VALSOU", "0.4"}, {"CATOBS", ""}, {"LNAM", "A"}});
    chart.add("OBSTRN", "POINT(0.25 0.5)", {{"VALSOU", ""}, {"CATOBS", "5,7"}, {"LNAM", "B"}});
    chart.add("OBSTRN", "POINT(0.25 0.75)", {{"VALSOU", ""}, {"CATOBS", "5,6"}, {"LNAM", "C"}});
    const auto found = chart.judged(vessel, 4326, true).violations({{0.1, 0.25}, {0.9, 0.25}});
    EXPECT_EQ(found.size(), 2U);
    EXPECT_TRUE(says(found, "leg 0 touches OBSTRN A (VALSOU 0.4 m)"));
    EXPECT_TRUE(says(found, "leg 0 touches OBSTRN C (no VALSOU, taken as 0.01 m)"));
}

// ---------------------------------------------------------------------------------------------------- touching

TEST(ChartOracle, anEdgeOrACornerIsATouchAndAHairBesideIsNot)
{
    auto chart = TinyChart::ofDeepWater();
    chart.add("LNDARE", TinyChart::box(0.25, 0.25, 0.375, 0.375));
    const ChartOracle oracle = chart.judged();
    const double hair = 1e-12;
    EXPECT_TRUE(says(oracle.violations({{0.375, 0.1}, {0.375, 0.4}}), "LNDARE")) << "along the edge";
    EXPECT_TRUE(free(oracle.violations({{0.375 + hair, 0.1}, {0.375 + hair, 0.4}})));
    EXPECT_TRUE(says(oracle.violations({{0.5, 0.25}, {0.25, 0.5}}), "LNDARE")) << "through the corner";
    EXPECT_TRUE(free(oracle.violations({{0.5 + hair, 0.25}, {0.25 + hair, 0.5}})));
    EXPECT_TRUE(says(oracle.violations({{0.3, 0.1}, {0.3, 0.25}}), "LNDARE")) << "ending on the edge";
    EXPECT_TRUE(says(oracle.violations({{0.3, 0.3}, {0.31, 0.31}}), "LNDARE")) << "wholly inside";
    const auto route = oracle.violations({{0.1, 0.1}, {0.1, 0.3}, {0.5, 0.3}, {0.5, 0.1}});
    ASSERT_EQ(route.size(), 1U);
    EXPECT_EQ(route.front().leg, 1U);
    EXPECT_TRUE(free(oracle.violations({})));
}

TEST(ChartOracle, agreesWithExactArithmeticOnACoarseGrid)
{
    // Triangles and legs on an 11 x 11 grid of sixteenths, exact in doubles: full of corners, edges and overlaps.
    using Node = std::array<long, 2>;
    const auto turn = [](const Node &a, const Node &b, const Node &c)
    {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    };
    const auto sign = [](long value)
    {
        return (value > 0) - (value < 0);
    };
    const auto onSegment = [&](const Node &a, const Node &b, const Node &p)
    {
        return turn(a, b, p) == 0 && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
               std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
    };
    const auto meet = [&](const Node &a, const Node &b, const Node &c, const Node &d)
    {
        return onSegment(a, b, c) || onSegment(a, b, d) || onSegment(c, d, a) || onSegment(c, d, b) ||
               (sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 && sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0);
    };
    std::size_t touches = 0;
    for (unsigned seed = 1; seed <= 4; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 generator(seed);
        const auto node = [&]
        {
            return Node{static_cast<long>(generator() % 11), static_cast<long>(generator() % 11)};
        };
        const auto degrees = [](long steps)
        {
            return static_cast<double>(steps + 2) / 16.0;
        };
        auto chart = TinyChart::ofDeepWater();
        std::vector<std::array<Node, 3>> triangles;
        while (triangles.size() < 12)
        {
            const std::array<Node, 3> t{node(), node(), node()};
            if (turn(t[0], t[1], t[2]) == 0)
                continue;
            const auto at = [&](const Node &n)
            {
                return TinyChart::at(degrees(n[0]), degrees(n[1]));
            };
            chart.add("LNDARE", "POLYGON((" + at(t[0]) + "," + at(t[1]) + "," + at(t[2]) + "," + at(t[0]) + "))",
                      {{"LNAM", "T" + std::to_string(triangles.size())}});
            triangles.push_back(t);
        }
        const ChartOracle oracle = chart.judged();
        for (int trial = 0; trial < 400; ++trial)
        {
            const Node a = node();
            const Node b = node();
            std::set<std::string> expected;
            for (std::size_t i = 0; i < triangles.size(); ++i)
            {
                const auto &t = triangles[i];
                const long way = sign(turn(t[0], t[1], t[2]));
                const bool inside =
                    way * turn(t[0], t[1], a) >= 0 && way * turn(t[1], t[2], a) >= 0 && way * turn(t[2], t[0], a) >= 0;
                if (inside || meet(a, b, t[0], t[1]) || meet(a, b, t[1], t[2]) || meet(a, b, t[2], t[0]))
                    expected.insert("leg 0 touches LNDARE T" + std::to_string(i) + " (always)");
            }
            std::set<std::string> found;
            for (const auto &violation :
                 oracle.violations({{degrees(a[1]), degrees(a[0])}, {degrees(b[1]), degrees(b[0])}}))
                found.insert(violation.what);
            ASSERT_EQ(found, expected) << a[0] << "," << a[1] << " to " << b[0] << "," << b[1];
            touches += expected.size();
        }
    }
    EXPECT_GT(touches, 1000U) << "the worlds are too empty to prove anything";
}

TEST(ChartOracle, pointsAreTouchedWithinANanodegreeOrWithinTheRadius)
{
    // At latitude 60 a degree is 111,412 m of latitude and 55,800 m of longitude.
    auto chart = TinyChart::ofDeepWater(59.5);
    chart.add("UWTROC", "POINT(0.25 60)");
    const ChartOracle oracle = chart.judged();
    const auto pastNorth = [](double metres)
    {
        return std::vector<LatLon>{{60.0 + metres / 111412.0, 0.2}, {60.0 + metres / 111412.0, 0.3}};
    };
    const auto pastEast = [](double metres)
    {
        return std::vector<LatLon>{{59.99, 0.25 + metres / 55800.0}, {60.01, 0.25 + metres / 55800.0}};
    };
    EXPECT_TRUE(says(oracle.violations({{60.0 + 5e-10, 0.2}, {60.0 + 5e-10, 0.3}}), "UWTROC"));
    EXPECT_TRUE(free(oracle.violations({{60.0 + 2e-9, 0.2}, {60.0 + 2e-9, 0.3}})));
    EXPECT_TRUE(says(oracle.violations({{59.9 + 1e-9, 0.15}, {60.1 + 1e-9, 0.35}}), "UWTROC")) << "0.7e-9 aslant";
    EXPECT_TRUE(free(oracle.violations({{59.9 + 3e-9, 0.15}, {60.1 + 3e-9, 0.35}}))) << "2.1e-9 aslant";
    EXPECT_TRUE(says(oracle.violationsWithin(pastNorth(9.99), 10.0), "leg 0 comes within 10 m of UWTROC"));
    EXPECT_TRUE(free(oracle.violationsWithin(pastNorth(10.01), 10.0)));
    EXPECT_TRUE(says(oracle.violationsWithin(pastEast(9.99), 10.0), "leg 0 comes within 10 m of UWTROC"));
    EXPECT_TRUE(free(oracle.violationsWithin(pastEast(10.01), 10.0)));
    EXPECT_NEAR(oracle.nearestHazard(pastNorth(800.0)).distanceM, 800.0, 0.8);
    EXPECT_NEAR(oracle.nearestHazard(pastEast(800.0)).distanceM, 800.0, 0.8);
    EXPECT_NEAR(oracle.nearestHazard({{59.9, 0.1}}).distanceM, std::hypot(0.1 * 111412.0, 0.15 * 55884.0), 60.0);
    EXPECT_EQ(oracle.nearestHazard({{59.9, 0.1}, {60.1, 0.4}}).distanceM, 0.0);
}

TEST(ChartOracle, nearestHazardNamesTheLegAndTheObject)
{
    auto chart = TinyChart::ofDeepWater();
    EXPECT_EQ(chart.judged().nearestHazard({{0.5, 0.5}}).distanceM, std::numeric_limits<double>::infinity());
    chart.add("LNDARE", TinyChart::box(0.4, 0.4, 0.6, 0.6), {{"LNAM", "I"}});
    chart.add("COALNE", "LINESTRING(0.95 0, 0.95 1)", {{"LNAM", "C"}});
    const auto nearest = chart.judged().nearestHazard({{0.1, 0.1}, {0.3, 0.1}, {0.39, 0.5}, {0.3, 0.9}});
    EXPECT_NEAR(nearest.distanceM, 0.01 * 110574.4, 0.1) << "a degree of latitude at the equator: 110,574 m";
    EXPECT_EQ(nearest.leg, 1U);
    EXPECT_EQ(nearest.what, "LNDARE I (always)");
    EXPECT_EQ(chart.judged().nearestHazard({{0.5, 0.5}}).distanceM, 0.0) << "inside an area";
}

// ---------------------------------------------------------------------------------------------------- coverage

TEST(ChartOracle, aSeamIsInsideTheCoverageAndItsOuterEdgeBelongsToIt)
{
    auto chart = TinyChart::ofDeepWater();
    chart.add("M_COVR", TinyChart::box(1.0, 0.0, 1.5, 1.0), {{"CATCOV", "2"}});
    chart.add("DEPARE", TinyChart::box(1.0, 0.0, 1.5, 1.0), {{"DRVAL1", "10"}});
    const ChartOracle oracle = chart.judged();
    EXPECT_TRUE(free(oracle.violations({{0.3, 0.1}, {0.7, 0.9}}))) << "across the seam";
    EXPECT_TRUE(free(oracle.violations({{0.1, 0.5}, {0.9, 0.5}}))) << "along the seam";
    EXPECT_TRUE(free(oracle.violations({{0.0, 0.1}, {0.0, 0.9}}))) << "along the outer edge";
    EXPECT_TRUE(says(oracle.violations({{0.5, 0.9}, {0.5, 1.1}}), "leg 0 leaves the coverage")) << "into CATCOV 2";
    EXPECT_TRUE(says(oracle.violations({{-1e-9, 0.1}, {-1e-9, 0.9}}), "leg 0 leaves the coverage"));
    EXPECT_TRUE(oracle.blocked(2.0, 0.5));
}

TEST(ChartOracle, aLegOverANotchLeavesTheCoverageBetweenItsEnds)
{
    TinyChart chart;
    const std::string notched = "POLYGON((0 0,1 0,1 1,0.75 1,0.75 0.5,0.25 0.5,0.25 1,0 1,0 0),"
                                "(0.4 0.1,0.6 0.1,0.6 0.3,0.4 0.3,0.4 0.1))";
    chart.add("M_COVR", notched, {{"CATCOV", "1"}});
    chart.add("DEPARE", notched, {{"DRVAL1", "10"}});
    const ChartOracle oracle = chart.judged();
    EXPECT_TRUE(says(oracle.violations({{0.75, 0.1}, {0.75, 0.9}}), "leaves the coverage")) << "over the notch";
    EXPECT_TRUE(says(oracle.violations({{0.2, 0.1}, {0.2, 0.9}}), "leaves the coverage")) << "over the hole";
    EXPECT_TRUE(says(oracle.violations({{1.0, 0.0}, {1.0, 1.0}}), "leaves the coverage")) << "edge, notch, edge";
    EXPECT_TRUE(free(oracle.violations({{0.5, 0.0}, {0.5, 1.0}}))) << "along the bottom of the notch";
    EXPECT_EQ(oracle.groupOneSums().difference(), 0);
    EXPECT_EQ(oracle.groupOneSums().coverage, 2 * std::llround((1.0 - 0.25 - 0.04) * 1e14));
}

TEST(ChartOracle, coverageInNoGroupOneAreaBlocks)
{
    TinyChart chart;
    chart.add("M_COVR", TinyChart::box(0, 0, 1, 1), {{"CATCOV", "1"}});
    chart.add("DEPARE", TinyChart::box(0, 0, 0.5, 1), {{"DRVAL1", "10"}});
    chart.add("DEPARE", TinyChart::box(0.5001, 0, 1, 1), {{"DRVAL1", "10"}});
    const ChartOracle oracle = chart.judged();
    EXPECT_EQ(oracle.groupOneSums().difference(), 2 * 1000LL * 10000000LL);
    const auto across = oracle.violations({{0.5, 0.1}, {0.5, 0.9}});
    ASSERT_EQ(across.size(), 1U);
    EXPECT_TRUE(says(across, "GAP (coverage in no group 1 area)"));
    EXPECT_TRUE(free(oracle.violations({{0.5, 0.1}, {0.5, 0.49}})));
}

// ---------------------------------------------------------------------------------------------------- the rest

TEST(ChartOracle, chartedDepthIsTheLeastAndUnknownStaysUnknown)
{
    auto chart = TinyChart::ofDeepWater();
    chart.add("DRGARE", TinyChart::box(0.2, 0.2, 0.3, 0.3), {{"DRVAL1", "4.5"}});
    chart.add("DRGARE", TinyChart::box(0.6, 0.2, 0.7, 0.3));
    const ChartOracle oracle = chart.judged();
    EXPECT_EQ(oracle.chartedDepth(0.5, 0.5), 10.0);
    EXPECT_EQ(oracle.chartedDepth(0.25, 0.25), 4.5);
    EXPECT_EQ(oracle.chartedDepth(0.3, 0.3), 4.5) << "a corner belongs to the area";
    EXPECT_EQ(oracle.chartedDepth(0.25, 0.65), std::nullopt);
    EXPECT_EQ(oracle.chartedDepth(3.0, 3.0), std::nullopt);
}

TEST(ChartOracle, listsWhatIsOverheadOrRegulated)
{
    auto chart = TinyChart::ofDeepWater();
    chart.add("BRIDGE", "LINESTRING(0.25 0,0.25 1)", {{"LNAM", "B1"}});
    chart.add("BRIDGE", "LINESTRING(0.9 0,0.9 1)", {{"LNAM", "B2"}});
    chart.add("RESARE", TinyChart::box(0.4, 0, 0.6, 1), {{"LNAM", "R1"}, {"RESTRN", "7,8"}});
    chart.add("DRGARE", TinyChart::box(0.6, 0.4, 0.7, 0.6), {{"LNAM", "D1"}, {"DRVAL1", "9"}});
    chart.add("DRGARE", TinyChart::box(0.7, 0.4, 0.8, 0.6), {{"LNAM", "D2"}, {"DRVAL1", "9"}, {"RESTRN", "1"}});
    const auto crossed = chart.judged().crossedOverheadAndRegulation({{0.5, 0.1}, {0.5, 0.5}, {0.5, 0.85}});
    EXPECT_EQ(std::set<std::string>(crossed.begin(), crossed.end()),
              (std::set<std::string>{"BRIDGE B1", "RESARE R1", "DRGARE D2"}));
    EXPECT_EQ(crossed.size(), 3U) << "each once";
}

TEST(ChartOracle, refusesWhatItCannotJudge)
{
    EXPECT_THROW(ChartOracle("/vsimem/no such chart.000", vessel), std::runtime_error);
    TinyChart uncovered;
    uncovered.add("DEPARE", TinyChart::box(0, 0, 1, 1), {{"DRVAL1", "10"}});
    EXPECT_THROW(uncovered.judged(), std::runtime_error);
    EXPECT_THROW(TinyChart::ofDeepWater().judged(vessel, 3857), std::runtime_error) << "metres for degrees";
    const ChartOracle oracle = TinyChart::ofDeepWater().judged();
    EXPECT_THROW(oracle.violations({{0.5, 0.5}, {std::nan(""), 0.5}}), std::runtime_error);
    EXPECT_THROW(oracle.blocked(91.0, 0.5), std::runtime_error);
    EXPECT_THROW(oracle.randomPairs(1, 1, 11.0, 0.1), std::runtime_error) << "no such water";
    EXPECT_THROW(oracle.randomPairs(1, 1, 5.0, 1.1), std::runtime_error) << "farther apart than the chart is wide";
}

// ---------------------------------------------------------------------------------------------------- real cells

/// Empty where there are no test data at all.
std::filesystem::path chartFolder()
{
    const char *data = std::getenv("SEAHEX_TEST_DATA");
    return data == nullptr || *data == '\0' ? std::filesystem::path() : std::filesystem::path(data) / "charts";
}

class ChartOracleOnCell : public testing::TestWithParam<const char *>
{
protected:
    void SetUp() override
    {
        if (chartFolder().empty())
            GTEST_SKIP() << "SEAHEX_TEST_DATA is not set: no real charts";
        cell_ = (chartFolder() / GetParam()).string();
        if (!std::filesystem::exists(cell_))
            GTEST_SKIP() << cell_ << " is missing";
    }

    std::string cell_;
};

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST_P(ChartOracleOnCell, groupOneTilesTheCoverage)
{
    const auto start = std::chrono::steady_clock::now();
    const ChartOracle oracle(cell_, vessel);
    std::cout << GetParam() << ": read in " << secondsSince(start) << " s; blocking:";
    const auto counts = oracle.blockingByClass();
    for (const auto &[name, count] : counts)
        std::cout << ' ' << name << ' ' << count;
    std::cout << '\n';
    EXPECT_GT(oracle.groupOneSums().coverage, 0);
    EXPECT_EQ(oracle.groupOneSums().difference(), 0);
    EXPECT_EQ(counts.count("GAP"), 0U);
    EXPECT_GT(counts.at("LNDARE"), 0U);
    EXPECT_GT(counts.at("DEPARE"), 0U);
}

TEST_P(ChartOracleOnCell, findsTheSameObjectsAsOgrsOwnSpatialFilter)
{
    // OGR, asked layer by layer with the leg as its filter, takes another way through the data than the oracle's
    // indices and prepared geometries.
    const ChartOracle oracle(cell_, vessel);
    const char *const options[] = {"UPDATES=APPLY", "LNAM_REFS=ON", nullptr};
    GDALDatasetUniquePtr dataset(GDALDataset::Open(cell_.c_str(), GDAL_OF_VECTOR, nullptr, options, nullptr));
    ASSERT_TRUE(dataset);
    std::vector<LatLon> islands;
    for (const auto &feature : *dataset->GetLayerByName("LNDARE"))
    {
        OGREnvelope box;
        feature->GetGeometryRef()->getEnvelope(&box);
        islands.emplace_back((box.MinY + box.MaxY) / 2, (box.MinX + box.MaxX) / 2);
    }
    // Half of the legs between random positions, half from one of them to the middle of a piece of land.
    std::size_t touches = 0;
    std::size_t number = 0;
    for (auto [from, to] : oracle.randomPairs(7, 8, 2.0, 0.3))
    {
        if (++number % 2 == 0)
            to = islands[number * islands.size() / 9];
        OGRLineString leg;
        leg.addPoint(from.second, from.first);
        leg.addPoint(to.second, to.first);
        std::set<std::string> expected;
        for (const char *name : {"LNDARE", "COALNE", "SLCONS", "PONTON", "DEPARE", "UNSARE"})
        {
            OGRLayer *layer = dataset->GetLayerByName(name);
            if (layer == nullptr)
                continue;
            layer->SetSpatialFilter(&leg);
            for (const auto &feature : *layer)
                if (std::string(name) != "DEPARE" || feature->GetFieldAsDouble("DRVAL1") < 1.7)
                    expected.insert(std::string(name) + " " + feature->GetFieldAsString("LNAM"));
        }
        std::set<std::string> found;
        for (const auto &violation : oracle.violations({from, to}))
            for (const char *name : {"LNDARE", "COALNE", "SLCONS", "PONTON", "DEPARE", "UNSARE"})
                if (violation.what.rfind("leg 0 touches " + std::string(name), 0) == 0)
                    found.insert(violation.what.substr(14, violation.what.find(" (") - 14));
        EXPECT_EQ(found, expected) << "from " << from.first << "," << from.second << " to " << to.first << ","
                                   << to.second;
        touches += expected.size();
    }
    EXPECT_GT(touches, 0U) << "no leg touches anything";
}

TEST_P(ChartOracleOnCell, randomPairsAreAfloatApartAndRepeatable)
{
    const ChartOracle oracle(cell_, vessel);
    const auto pairs = oracle.randomPairs(42, 10, 3.0, 0.3);
    ASSERT_EQ(pairs.size(), 10U);
    EXPECT_EQ(pairs, oracle.randomPairs(42, 10, 3.0, 0.3));
    EXPECT_NE(pairs, oracle.randomPairs(43, 10, 3.0, 0.3));
    for (const auto &pair : pairs)
        for (const LatLon &position : {pair.first, pair.second})
        {
            EXPECT_FALSE(oracle.blocked(position.first, position.second));
            EXPECT_GE(oracle.chartedDepth(position.first, position.second).value_or(-1.0), 3.0);
            EXPECT_GT(oracle.nearestHazard({position}).distanceM, 0.0);
        }
}

TEST_P(ChartOracleOnCell, judgesARawRouteOfFiveThousandLegsAtOnce)
{
    const ChartOracle oracle(cell_, vessel);
    const auto pair = oracle.randomPairs(1, 1, 2.0, 0.3).front();
    std::vector<LatLon> route;
    for (int i = 0; i <= 5000; ++i)
        route.emplace_back(pair.first.first + (pair.second.first - pair.first.first) * i / 5000.0 + (i % 2) * 1e-4,
                           pair.first.second + (pair.second.second - pair.first.second) * i / 5000.0);
    const auto start = std::chrono::steady_clock::now();
    const auto strict = oracle.violationsWithin(route, 10.0);
    const double elapsed = secondsSince(start);
    std::cout << GetParam() << ": 5000 legs in " << elapsed << " s, " << strict.size() << " violations\n";
    EXPECT_LT(elapsed, 5.0);
    EXPECT_GE(strict.size(), oracle.violations(route).size()) << "a keep-out radius can only add";
}

TEST(ChartOracle, judgesACellWithItsUpdates)
{
    const auto folder = chartFolder() / "generated";
    if (chartFolder().empty() || !std::filesystem::exists(folder / "with_updates"))
        GTEST_SKIP() << "SEAHEX_TEST_DATA is unset or holds no charts/generated/with_updates";
    const ChartOracle before((folder / "ZZ4SHCHN.000").string(), vessel);
    const ChartOracle after((folder / "with_updates" / "ZZ4SHCHN.000").string(), vessel);
    // The first update inserts three wrecks of 1.5 m, the second makes one of 4.3 m into one of 0.7 m.
    for (const LatLon &wreck : {LatLon{21.5628391, 112.9114527}, LatLon{21.7597185, 112.7506224},
                                LatLon{21.9197723, 112.7703538}, LatLon{21.5958705, 112.8296795}})
    {
        EXPECT_FALSE(says(before.violations({wreck}), "touches WRECKS"));
        EXPECT_TRUE(says(after.violations({wreck}), "touches WRECKS"));
    }
    EXPECT_EQ(after.blockingByClass().at("UWTROC") + 1, before.blockingByClass().at("UWTROC")) << "one is deleted";
}

INSTANTIATE_TEST_SUITE_P(Cells, ChartOracleOnCell,
                         testing::Values("noaa/US3DE01M/US3DE01M.000", "noaa/US4AK3SB/US4AK3SB.000",
                                         "noaa/US4MD81M/US4MD81M.000", "noaa/US5MA12M/US5MA12M.000",
                                         "noaa/US5MD1MC/US5MD1MC.000", "generated/ZZ3NORWY.000",
                                         "generated/ZZ4SANYA.000", "generated/ZZ4SHCHN.000",
                                         "generated/with_updates/ZZ4SHCHN.000"));

}  // namespace
