// plan_route --cells: a second run takes the cells from the file, and no run takes those of another chart or vessel.

#include "demos/PlanRoute.h"

using namespace seahex::test;

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace
{

class PlanRouteCells : public testing::Test
{
protected:
    PlanRouteCells() { fs::copy_file(shangchuan(), chart_); }

    Json report(const Arguments &more = {}, const std::string &pitch = "100") const
    {
        return routeReport(Arguments{"--chart", chart_.string(), "--from", "21.635,112.521", "--to", "21.669,112.901",
                                     "--pitch", pitch} +
                           more);
    }

    Json keeping(const Arguments &more = {}, const std::string &pitch = "100") const
    {
        return report(Arguments{"--cells", file_.string()} + more, pitch);
    }

    /// The cells come from where they must, and the route is that of a run without a file.
    void expectFrom(const char *source, const Json &kept, const Arguments &more = {}) const
    {
        ASSERT_TRUE(kept.is_object());
        EXPECT_EQ(kept.at("cells_from"), source);
        const Json plain = report(more);
        ASSERT_TRUE(plain.is_object());
        EXPECT_EQ(plain.at("cells_from"), "chart");
        for (const char *key : {"raw", "smoothed", "expanded", "start_cell", "goal_cell"})
            EXPECT_EQ(kept.at(key), plain.at(key)) << key;
        EXPECT_EQ(kept.at("lattice").at("blocked"), plain.at("lattice").at("blocked"));
    }

    std::string warning(const Json &kept) const
    {
        if (!kept.is_object())
            return "no report";
        const Json &warnings = kept.at("cells_warnings");
        EXPECT_LE(warnings.size(), 1u);
        return warnings.empty() ? "" : warnings.at(0).get<std::string>();
    }

    TemporaryFolder folder_;
    fs::path chart_ = folder_ / "chart.000";
    fs::path file_ = folder_ / "cells";
};

TEST_F(PlanRouteCells, ofTheSecondRunAreThoseOfTheFirst)
{
    expectFrom("chart", keeping());
    const std::string bytes = readBytes(file_);
    const Json second = keeping();
    expectFrom("file", second);
    EXPECT_EQ(warning(second), "");
    EXPECT_EQ(readBytes(file_), bytes);
    expectSafe(second, ChartOracle(chart_.string(), {1.2, 0.5}));
    expectFrom("file", keeping({"--rings", "1", "--no-smoothing"}), {"--rings", "1", "--no-smoothing"});

    const ProgramResult text = planRoute(aroundShangchuan() + Arguments{"--cells", (folder_ / "other").string()});
    EXPECT_NE(text.out.find("filled in"), std::string::npos) << text.out;
    const ProgramResult again = planRoute(aroundShangchuan() + Arguments{"--cells", (folder_ / "other").string()});
    EXPECT_NE(again.out.find("taken from the file in"), std::string::npos) << again.out;
}

TEST_F(PlanRouteCells, ofAnotherVesselOrPitchAreNotUsed)
{
    keeping();
    for (const Arguments &more :
         {Arguments{"--draught", "1.5"}, Arguments{"--ukc", "0.6"}, Arguments{"--margin", "30"}})
    {
        SCOPED_TRACE(testing::PrintToString(more));
        const Json kept = keeping(more);
        expectFrom("chart", kept, more);
        EXPECT_EQ(warning(kept), "") << "it is no fault";
    }
    const Json finer = keeping({"--margin", "30"}, "99");
    ASSERT_TRUE(finer.is_object());
    EXPECT_EQ(finer.at("cells_from"), "chart");
    EXPECT_EQ(finer.at("lattice").at("pitch"), 99.0);
}

TEST_F(PlanRouteCells, ofAnotherChartAreNotUsed)
{
    keeping();
    // one byte of the chart, which says nothing of water
    std::string bytes = readBytes(chart_);
    const std::string date = report().at("chart").at("cells").at(0).at("issued");
    ASSERT_EQ(date.size(), 8u);
    char &digit = bytes.at(bytes.find(date) + 7);
    digit = digit == '1' ? '2' : '1';
    writeBytes(chart_, bytes);
    expectFrom("chart", keeping());
    expectFrom("file", keeping());

    // another chart of the same name
    fs::remove(chart_);
    fs::copy_file(sanya(), chart_);
    const Json other = routeReport({"--chart", chart_.string(), "--from", "18.15,109.38", "--to", "18.13,109.75",
                                    "--pitch", "100", "--cells", file_.string()});
    ASSERT_TRUE(other.is_object());
    EXPECT_EQ(other.at("cells_from"), "chart");
    expectSafe(other, ChartOracle(sanya(), {1.2, 0.5}));
}

TEST_F(PlanRouteCells, ofADamagedFileAreFilledAnewWithAWarning)
{
    keeping();
    const std::string whole = readBytes(file_);
    std::string damaged = whole;
    damaged.at(whole.size() / 2) = static_cast<char>(damaged.at(whole.size() / 2) ^ 4);
    for (const std::string &bytes : {damaged, whole.substr(0, whole.size() / 2)})
    {
        writeBytes(file_, bytes);
        const Json kept = keeping();
        expectFrom("chart", kept);
        EXPECT_NE(warning(kept).find("replaced"), std::string::npos) << warning(kept);
        EXPECT_EQ(readBytes(file_), whole);
        expectFrom("file", keeping());
    }

    writeBytes(file_, damaged);
    const ProgramResult text = planRoute({"--chart", chart_.string(), "--from", "21.635,112.521", "--to",
                                          "21.669,112.901", "--pitch", "100", "--cells", file_.string()});
    EXPECT_NE(text.out.find("warning: '" + file_.string()), std::string::npos) << text.out;
}

TEST_F(PlanRouteCells, neverTakeThePlaceOfAnotherFile)
{
    const std::string letter = "Dear harbour master,\n";
    writeBytes(file_, letter);
    const Json kept = keeping();
    expectFrom("chart", kept);
    EXPECT_NE(warning(kept).find("left alone"), std::string::npos) << warning(kept);
    EXPECT_EQ(readBytes(file_), letter);

    const std::string before = readBytes(chart_);
    const auto exitOf = [this](const Arguments &more)
    {
        return planRoute(Arguments{"--chart", chart_.string(), "--from", "21.635,112.521", "--to", "21.669,112.901",
                                   "--pitch", "100"} +
                         more)
            .exitCode;
    };
    const std::string both = (folder_ / "both.png").string();
    EXPECT_EQ(exitOf({"--cells", chart_.string()}), 2);
    EXPECT_EQ(readBytes(chart_), before);
    EXPECT_EQ(exitOf({"--cells", folder_.path().string()}), 2);
    EXPECT_EQ(exitOf({"--cells", (folder_ / "no" / "cells").string()}), 2);
    EXPECT_EQ(exitOf({"--cells", both, "--out", both}), 2);
    EXPECT_EQ(exitOf({"--cells", both, "--picture", both}), 2);
    EXPECT_FALSE(fs::exists(both));
}

}  // namespace
