#include "seahex/world/KeptOccupancy.h"

#include "seahex/world/OccupancyBuilder.h"
#include "seahex/world/OccupancyFile.h"

#include "support/TestCharts.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using namespace seahex;
using namespace seahex::test;

namespace fs = std::filesystem;

namespace
{

/// A few cells, of which as many are blocked as points are given.
std::shared_ptr<const HexOccupancy> cellsWith(int points)
{
    const HexLattice lattice(Point(0.0, 0.0), 1.0, 20, 10);
    OccupancyBuilder builder(lattice);
    for (int i = 0; i < points; ++i)
    {
        Shape shape;
        shape.points.push_back(lattice.centre(lattice.cell({i, 3})));
        builder.block(shape, 0.1);
    }
    return std::move(builder).build();
}

class KeptCells : public testing::Test
{
protected:
    /// Keeps cells with as many blocked as points are given, if they are made.
    KeptOccupancy keep(const std::string &provenance, int points)
    {
        return loadOrMake(file_, provenance,
                          [this, points]
                          {
                              ++made_;
                              return cellsWith(points);
                          });
    }

    void expectFromFile(const KeptOccupancy &kept, int points) const { expect(kept, points, true, ""); }
    void expectMade(const KeptOccupancy &kept, int points, const std::string &warning = "") const
    {
        expect(kept, points, false, warning);
    }

    TemporaryFolder folder_;
    fs::path file_ = folder_ / "cells";
    int made_ = 0;

private:
    void expect(const KeptOccupancy &kept, int points, bool fromFile, const std::string &warning) const
    {
        ASSERT_NE(kept.occupancy, nullptr);
        EXPECT_EQ(kept.occupancy->words(), cellsWith(points)->words());
        EXPECT_EQ(kept.isFromFile, fromFile);
        ASSERT_EQ(kept.warnings.size(), warning.empty() ? 0u : 1u) << testing::PrintToString(kept.warnings);
        if (!warning.empty())
        {
            EXPECT_NE(kept.warnings.front().find(warning), std::string::npos) << kept.warnings.front();
            EXPECT_NE(kept.warnings.front().find(file_.string()), std::string::npos) << kept.warnings.front();
        }
    }
};

TEST_F(KeptCells, areMadeOnce)
{
    expectMade(keep("a", 3), 3);
    expectFromFile(keep("a", 5), 3);
    expectFromFile(keep("a", 5), 3);
    EXPECT_EQ(made_, 1);
}

TEST_F(KeptCells, ofSomethingElseAreReplacedWithoutAWord)
{
    keep("a", 3);
    for (const std::string provenance : {"b", "a ", "", "A"})
    {
        SCOPED_TRACE(provenance);
        expectMade(keep(provenance, 5), 5);
        expectFromFile(keep(provenance, 9), 5);
    }
    expectMade(keep("a", 4), 4);
}

TEST_F(KeptCells, ofADamagedFileAreReplacedWithAWarning)
{
    keep("a", 3);
    const std::string whole = readBytes(file_);
    const auto cells = cellsWith(3);
    const auto middle = static_cast<std::size_t>(cells->layout().index(OffsetCoord{10, 5})) / 8;
    const std::size_t amidst = whole.size() - cells->words().size() * 8 + middle;  // the frame is farther than 8 cells
    for (const std::size_t at : {std::size_t{9}, std::size_t{12}, std::size_t{40}, std::size_t{88}, amidst})
    {
        SCOPED_TRACE(at);
        std::string bytes = whole;
        bytes.at(at) = static_cast<char>(bytes.at(at) ^ 0x20);
        writeBytes(file_, bytes);
        expectMade(keep("a", 4), 4, "replaced");
        expectFromFile(keep("a", 5), 4);
    }
    for (const std::size_t length : {std::size_t{8}, std::size_t{60}, whole.size() - 1})
    {
        SCOPED_TRACE(length);
        writeBytes(file_, whole.substr(0, length));
        expectMade(keep("a", 4), 4, "replaced");
        expectFromFile(keep("a", 5), 4);
    }
}

TEST_F(KeptCells, neverTakeThePlaceOfAnotherFile)
{
    for (const std::string bytes : {"x", "SEAHEX", "{\"type\": \"FeatureCollection\", \"features\": []}"})
    {
        writeBytes(file_, bytes);
        expectMade(keep("a", 3), 3, "left alone");
        EXPECT_EQ(readBytes(file_), bytes);
    }
    fs::remove(file_);
    fs::create_directory(file_);
    expectMade(keep("a", 3), 3, "left alone");
    EXPECT_TRUE(fs::is_directory(file_));
}

TEST_F(KeptCells, takeAnEmptyFile)
{
    writeBytes(file_, "");
    expectMade(keep("a", 3), 3);
    expectFromFile(keep("a", 5), 3);
}

TEST_F(KeptCells, thatCanNotBeWrittenAreThereNevertheless)
{
    file_ = folder_ / "nowhere" / "cells";
    expectMade(keep("a", 3), 3, "can't be written");
}

TEST_F(KeptCells, behindALinkLeaveItALink)
{
    const fs::path target = folder_ / "target";
    writeBytes(target, "");
    fs::create_symlink(target, file_);
    expectMade(keep("a", 3), 3);
    EXPECT_TRUE(fs::is_symlink(file_));
    EXPECT_TRUE(isOccupancyFile(target));
    expectFromFile(keep("a", 5), 3);
}

TEST_F(KeptCells, thatCanNotBeMadeLeaveTheFileAsItWas)
{
    keep("a", 3);
    const std::string before = readBytes(file_);
    EXPECT_THROW(
        loadOrMake(file_, "b", []() -> std::shared_ptr<const HexOccupancy> { throw std::runtime_error("no cells"); }),
        std::runtime_error);
    EXPECT_EQ(readBytes(file_), before);
}

}  // namespace
