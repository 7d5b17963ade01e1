#include "seahex/chart/ChartError.h"
#include "seahex/chart/ChartReader.h"

#include "support/TestCharts.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

using namespace seahex;
using namespace seahex::test;

namespace fs = std::filesystem;

namespace
{

/// Reads and expects an error of the type whose message holds the words.
template <class Error>
void expectError(const fs::path &source, const std::string &words)
{
    try
    {
        readChart(source.string());
        ADD_FAILURE() << source << " is read without an error; '" << words << "' was expected";
    }
    catch (const Error &error)
    {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
    catch (const std::exception &error)
    {
        ADD_FAILURE() << "another error: " << error.what();
    }
}

bool isWarnedOf(const Chart &chart, const std::string &words)
{
    const auto &warnings = chart.cells.at(0).warnings;
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const std::string &warning) { return warning.find(words) != std::string::npos; });
}

/// A copy of a generated cell to be damaged, without updates.
class DamagedCell : public testing::Test
{
protected:
    void SetUp() override
    {
        SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
        original_ = charts / "generated" / "with_updates" / "ZZ4SHCHN.000";
        bytes_ = readBytes(original_);
        cell_ = folder_ / "ZZ4SHCHN.000";
    }

    fs::path update(int number) const { return fs::path(cell_).replace_extension(".00" + std::to_string(number)); }

    std::string updateBytes(int number) const
    {
        return readBytes(fs::path(original_).replace_extension(".00" + std::to_string(number)));
    }

    /// Changes one byte behind a pattern that occurs once.
    std::string patched(const std::string &bytes, const std::string &pattern, std::size_t offset, char value) const
    {
        const std::size_t at = bytes.find(pattern);
        EXPECT_NE(at, std::string::npos);
        EXPECT_EQ(bytes.find(pattern, at + 1), std::string::npos);
        std::string changed = bytes;
        changed.at(at + offset) = value;
        return changed;
    }

    /// DSNM, EDTN and UPDN follow each other as texts that end with a unit separator.
    static constexpr const char *EDITION_1_UPDATE_0 = "ZZ4SHCHN.000\x1f"
                                                      "1\x1f"
                                                      "0\x1f";
    static constexpr std::size_t EDITION = 13;
    static constexpr std::size_t UPDATE = 15;

    TemporaryFolder folder_;
    fs::path original_;
    fs::path cell_;
    std::string bytes_;
};

TEST_F(DamagedCell, cutAnywhereIsRefused)
{
    // Prime steps, so that cuts fall everywhere in a record.
    for (std::size_t length = 0; length < bytes_.size(); length += 3571)
    {
        writeBytes(cell_, bytes_.substr(0, length));
        EXPECT_THROW(readChart(cell_.string()), ChartError) << "cut to " << length << " bytes";
    }
    for (std::size_t lost : {1, 2, 10, 40})
    {
        writeBytes(cell_, bytes_.substr(0, bytes_.size() - lost));
        EXPECT_THROW(readChart(cell_.string()), ChartError) << lost << " bytes lost";
    }
}

TEST_F(DamagedCell, cutBetweenRecordsIsRefused)
{
    const std::vector<std::size_t> starts = recordStarts(bytes_);
    ASSERT_GT(starts.size(), 500u);
    for (std::size_t records = 1; records + 1 < starts.size(); records += records < 20 ? 1 : 37)
    {
        writeBytes(cell_, bytes_.substr(0, starts[records]));
        EXPECT_THROW(readChart(cell_.string()), ChartDamaged) << records << " records";
    }
    writeBytes(cell_, bytes_.substr(0, starts[starts.size() - 2]));
    expectError<ChartDamaged>(cell_, "holds 236 of 237 feature records: the file is cut or damaged");
}

TEST_F(DamagedCell, cutBesideAnUpdateIsRefused)
{
    // The base is then not read by itself, and its loss must not be taken for the update's doing.
    writeBytes(update(1), updateBytes(1));
    const std::vector<std::size_t> starts = recordStarts(bytes_);
    for (std::size_t records = 1; records + 1 < starts.size(); records += records < 20 ? 1 : 37)
    {
        writeBytes(cell_, bytes_.substr(0, starts[records]));
        EXPECT_THROW(readChart(cell_.string()), ChartDamaged) << records << " records";
    }
    writeBytes(cell_, bytes_.substr(0, starts[starts.size() - 2]));
    expectError<ChartDamaged>(cell_, "holds 236 of 237 feature records: the file is cut or damaged");
    writeBytes(cell_, bytes_.substr(0, starts[20]) + bytes_.substr(starts[21]));
    expectError<ChartDamaged>(cell_, "spatial records");
    writeBytes(cell_, bytes_.substr(0, bytes_.size() - 2));
    EXPECT_THROW(readChart(cell_.string()), ChartError);
    writeBytes(cell_, bytes_ + "x");
    EXPECT_THROW(readChart(cell_.string()), ChartError);
    writeBytes(cell_, bytes_);
    EXPECT_EQ(readChart(cell_.string()).cells.at(0).update, 1);
}

TEST_F(DamagedCell, withARecordTwiceIsRefused)
{
    const std::vector<std::size_t> starts = recordStarts(bytes_);
    const std::string node = bytes_.substr(starts[20], starts[21] - starts[20]);
    for (const bool withUpdate : {false, true})
    {
        if (withUpdate)
            writeBytes(update(1), updateBytes(1));
        writeBytes(cell_, bytes_.substr(0, starts[20]) + node + bytes_.substr(starts[20]));
        expectError<ChartDamaged>(cell_, "spatial records");
    }
}

TEST_F(DamagedCell, withoutASpatialRecordIsRefused)
{
    const std::vector<std::size_t> starts = recordStarts(bytes_);
    // Record 20 is a node: the first records are the header and the parameters, the features come last.
    writeBytes(cell_, bytes_.substr(0, starts[20]) + bytes_.substr(starts[21]));
    expectError<ChartDamaged>(cell_, "spatial records");
}

TEST_F(DamagedCell, withFlippedBytesNeverCrashes)
{
    constexpr unsigned SEED = 20240607;
    SCOPED_TRACE("seed " + std::to_string(SEED));
    std::mt19937 random(SEED);
    int refused = 0;
    constexpr int TRIES = 150;
    for (int i = 0; i < TRIES; ++i)
    {
        std::string changed = bytes_;
        for (int flips = 0; flips < 3; ++flips)
            changed[random() % changed.size()] = static_cast<char>(random() & 0xff);
        writeBytes(cell_, changed);
        try
        {
            readChart(cell_.string());
        }
        catch (const ChartError &)
        {
            ++refused;
        }
    }
    EXPECT_GT(refused, 0);
    EXPECT_LT(refused, TRIES);
}

TEST_F(DamagedCell, inFeetIsUnsupported)
{
    // CSCL 50000, then the units of depth, height, position and coordinates.
    const std::string units("\x50\xc3\x00\x00\x01\x01\x01\x01", 8);
    writeBytes(cell_, patched(bytes_, units, 4, 2));
    expectError<ChartUnsupported>(cell_, "DUNI) is 2");
    writeBytes(cell_, patched(bytes_, units, 7, 2));
    expectError<ChartUnsupported>(cell_, "COUN) is 2");
}

TEST_F(DamagedCell, withoutCoverageIsEmpty)
{
    // CATCOV (attribute 18) 1 becomes 2.
    writeBytes(cell_, patched(bytes_, std::string("\x12\x00\x31\x1f", 4), 2, '2'));
    expectError<ChartEmpty>(cell_, "no coverage");
}

TEST_F(DamagedCell, goesOnWithUpdatesOnlyAsFarAsTheyFollowEachOther)
{
    writeBytes(cell_, bytes_);
    writeBytes(update(2), updateBytes(2));
    const Chart chart = readChart(cell_.string());
    EXPECT_EQ(chart.cells.at(0).update, 0);
    EXPECT_TRUE(isWarnedOf(chart, "update 1 of")) << "no warning of the missing update";

    writeBytes(update(1), updateBytes(1));
    EXPECT_EQ(readChart(cell_.string()).cells.at(0).update, 2);
}

TEST_F(DamagedCell, withABadUpdateIsRefused)
{
    writeBytes(cell_, bytes_);
    writeBytes(update(1), "no update at all");
    expectError<ChartDamaged>(cell_, "can't be read as S-57");
    writeBytes(update(1), "");
    expectError<ChartDamaged>(cell_, "can't be read as S-57");

    const std::string whole = updateBytes(1);
    writeBytes(update(1), whole.substr(0, whole.size() - 40));
    expectError<ChartDamaged>(cell_, "can't be read as S-57");

    const std::vector<std::size_t> starts = recordStarts(whole);
    writeBytes(update(1), whole.substr(0, starts[starts.size() - 2]));
    expectError<ChartDamaged>(cell_, "holds 2 of 3 feature records");

    writeBytes(update(1), updateBytes(2));
    expectError<ChartDamaged>(cell_, "number 2, but its name says 1");
}

TEST_F(DamagedCell, reissuedAtALaterUpdateContainsTheEarlierOnes)
{
    writeBytes(cell_, patched(bytes_, EDITION_1_UPDATE_0, UPDATE, '1'));
    EXPECT_EQ(readChart(cell_.string()).cells.at(0).update, 1);

    writeBytes(update(1), updateBytes(1));
    const Chart chart = readChart(cell_.string());
    EXPECT_EQ(chart.cells.at(0).update, 1);
    EXPECT_TRUE(isWarnedOf(chart, "already part of the cell"));

    // The driver can't apply an update to a re-issued cell: a chart without it would be out of date unseen.
    writeBytes(update(2), updateBytes(2));
    EXPECT_THROW(readChart(cell_.string()), ChartDamaged);
    fs::remove(update(1));
    expectError<ChartDamaged>(cell_, "can't be applied");
}

TEST_F(DamagedCell, ofALaterEditionLeavesOldUpdates)
{
    writeBytes(cell_, patched(bytes_, EDITION_1_UPDATE_0, EDITION, '2'));
    writeBytes(update(1), updateBytes(1));
    const Chart chart = readChart(cell_.string());
    EXPECT_EQ(chart.cells.at(0).edition, 2);
    EXPECT_EQ(chart.cells.at(0).update, 0);
    EXPECT_TRUE(isWarnedOf(chart, "earlier edition 1"));
}

TEST_F(DamagedCell, ofAnEarlierEditionThanItsUpdateIsRefused)
{
    writeBytes(cell_, patched(bytes_, EDITION_1_UPDATE_0, EDITION, '0'));
    writeBytes(update(1), updateBytes(1));
    expectError<ChartDamaged>(cell_, "belongs to edition 1");
}

TEST(BadChart, sourcesThatAreNoCharts)
{
    const TemporaryFolder folder;
    expectError<ChartUnreadable>(folder / "missing.000", "does not exist");
    expectError<ChartUnreadable>(folder.path(), "holds no chart");
    writeBytes(folder / "notes.txt", "no chart");
    expectError<ChartUnreadable>(folder.path(), "holds no chart");
    expectError<ChartUnreadable>(folder / "notes.txt", "can't be read as a chart");
    EXPECT_THROW(readChart(std::vector<std::string>{}), ChartUnreadable);
    EXPECT_THROW(readChart(std::string()), ChartUnreadable);

    writeBytes(folder / "PICTURE.000",
               std::string("\xff\xd8\xff\xe0\x00\x10JFIF\x00\x01\x01", 13) + std::string(500, 'x'));
    expectError<ChartUnreadable>(folder / "PICTURE.000", "can't be read as an S-57 cell");
    writeBytes(folder / "PICTURE.000", std::string("\x89PNG\r\n\x1a\n", 8) + std::string(500, '\0'));
    expectError<ChartUnreadable>(folder / "PICTURE.000", "can't be read as an S-57 cell");
    writeBytes(folder / "PICTURE.000", "a text of some length that is no chart\n");
    expectError<ChartUnreadable>(folder / "PICTURE.000", "can't be read as an S-57 cell");
    writeBytes(folder / "PICTURE.000", "");
    expectError<ChartUnreadable>(folder / "PICTURE.000", "can't be read as an S-57 cell");
    writeBytes(folder / "PICTURE.001", "");
    expectError<ChartUnreadable>(folder / "PICTURE.001", "is an update");
}

TEST(BadChart, layersThatCantBeUsed)
{
    const TemporaryFolder folder;
    const std::string box = boxWkt(10.0, 50.0, 10.1, 50.1);
    const TestLayer coverage{"M_COVR", {{box, {{"CATCOV", 1}}}}};
    const TestLayer water{"DEPARE", {{box, {{"DRVAL1", 5.0}}}}};

    writeChart(folder / "unnamed.gpkg", {{"roads", {{box, {}}}}});
    expectError<ChartUnsupported>(folder / "unnamed.gpkg", "no layer that bears the name of an S-57 class");

    writeChart(folder / "land.gpkg", {coverage, {"LNDARE", {{box, {}}}}});
    expectError<ChartEmpty>(folder / "land.gpkg", "no water to sail in");

    writeChart(folder / "marks.gpkg", {{"WRECKS", {{"POINT (10 50)", {}}}}});
    expectError<ChartEmpty>(folder / "marks.gpkg", "neither coverage");

    writeChart(folder / "nowhere.gpkg", {coverage, water, {"WRECKS", {{"", {{"VALSOU", 1.0}}}}}});
    expectError<ChartDamaged>(folder / "nowhere.gpkg", "WRECKS fid 1");

    writeChart(folder / "beyond.gpkg", {coverage, water, {"WRECKS", {{"POINT (10 91)", {}}}}});
    expectError<ChartDamaged>(folder / "beyond.gpkg", "no position");

    writeChart(folder / "far.gpkg", {coverage, water, {"WRECKS", {{"LINESTRING (10 50, 1e300 50)", {}}}}});
    expectError<ChartDamaged>(folder / "far.gpkg", "no position");

    writeChart(folder / "feet.gpkg", {coverage, water, {"M_UNIT", {{box, {{"DUNITS", 3}}}}}});
    expectError<ChartUnsupported>(folder / "feet.gpkg", "DUNITS is 3");
}

}  // namespace
