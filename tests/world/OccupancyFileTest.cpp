#include "seahex/world/OccupancyFile.h"

#include "seahex/world/OccupancyBuilder.h"

#include "support/Random.h"
#include "support/RandomShapes.h"
#include "support/TestCharts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

using namespace seahex;
using namespace seahex::test;

namespace fs = std::filesystem;

namespace
{

const std::string PROVENANCE = "chart US5MA12M edition 29, draught 1.2 m";
constexpr std::size_t HEAD = 88;

template <class KnownLattice>
auto filledOccupancy(Random &random, const KnownLattice &lattice)
{
    OccupancyBuilder builder(lattice);
    for (int i = 0; i < 5; ++i)
    {
        Shape shape;
        shape.areas.push_back(randomArea(random, random.pointIn(lattice.bounds()), random.real(1.0, 20.0), true));
        builder.block(shape, 0.3);
    }
    return std::move(builder).build();
}

class OccupancyFile : public testing::Test
{
protected:
    OccupancyFile()
    {
        Random random(5);
        saved_ = filledOccupancy(random, HexLattice(Point(-3.25, 71.5), 1.5, 130, 90));
        saveOccupancy(file_, *saved_, PROVENANCE);
        bytes_ = readBytes(file_);
    }

    std::string refusal(FileTrust trust = FileTrust::Verify, const std::string &provenance = PROVENANCE) const
    {
        try
        {
            loadHexOccupancy(file_, provenance, trust);
            return "none";
        }
        catch (const OccupancyFileError &error)
        {
            EXPECT_NE(std::string(error.what()).find(file_.string()), std::string::npos) << "it names the file";
            return error.what();
        }
    }

    std::string refusalOf(const std::string &bytes, FileTrust trust = FileTrust::Verify) const
    {
        writeBytes(file_, bytes);
        return refusal(trust);
    }

    std::string changed(std::size_t at, char flips = 0x10) const
    {
        std::string bytes = bytes_;
        bytes.at(at) = static_cast<char>(bytes.at(at) ^ flips);
        return bytes;
    }

    TemporaryFolder folder_;
    fs::path file_ = folder_ / "cells.seahex";
    std::shared_ptr<const HexOccupancy> saved_;
    std::string bytes_;
};

void expectHolds(const std::string &text, const std::string &words)
{
    EXPECT_NE(text.find(words), std::string::npos) << text;
}

TEST(OccupancyFiles, giveBackWhatWasSaved)
{
    const TemporaryFolder folder;
    for (std::uint64_t seed = 1; seed <= 30; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const Point northWest(random.real(-1e6, 1e6), random.real(-1e6, 1e6));
        const auto columns = static_cast<std::int64_t>(random.real(1.0, 200.0));
        const auto rows = static_cast<std::int64_t>(random.real(1.0, 100.0));
        const double pitch = random.real(0.1, 3.0);
        const std::string provenance(static_cast<std::size_t>(random.real(0.0, 9000.0)), 'p');

        const auto hexes = filledOccupancy(random, HexLattice(northWest, pitch, columns, rows));
        saveOccupancy(folder / "hex", *hexes, provenance);
        const auto squares = filledOccupancy(random, SquareLattice(northWest, pitch, columns, rows));
        saveOccupancy(folder / "square", *squares, provenance);
        for (const FileTrust trust : {FileTrust::Verify, FileTrust::OwnFiles})
        {
            const auto hex = loadHexOccupancy(folder / "hex", provenance, trust);
            ASSERT_EQ(hex->words(), hexes->words());
            ASSERT_EQ(hex->lattice(), hexes->lattice());
            ASSERT_EQ(hex->blockedCount(), hexes->blockedCount());
            const auto square = loadSquareOccupancy(folder / "square", provenance, trust);
            ASSERT_EQ(square->words(), squares->words());
            ASSERT_EQ(square->lattice(), squares->lattice());
        }
        ASSERT_EQ(readProvenance(folder / "hex"), provenance);
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 2)
        << "no partial file is left";
}

TEST_F(OccupancyFile, outlivesItsNameAndWhateverTakesIt)
{
    const auto loaded = loadHexOccupancy(file_, PROVENANCE);
    const CellWords words = loaded->words();
    saveOccupancy(file_,
                  HexOccupancy(HexLattice(Point(0, 0), 1.0, 1, 1), CellLayout(1, 1),
                               std::vector<std::uint64_t>(CellLayout(1, 1).wordCount(), ~std::uint64_t{0})),
                  PROVENANCE);
    EXPECT_EQ(words, saved_->words());
    EXPECT_EQ(loadHexOccupancy(file_, PROVENANCE)->blockedCount(), 1);
    fs::remove(file_);
    EXPECT_EQ(words, saved_->words());
}

TEST_F(OccupancyFile, ofSomethingElseIsNeverUsed)
{
    expectHolds(refusal(FileTrust::OwnFiles, "chart US5MA12M edition 30, draught 1.2 m"), "something else");
    expectHolds(refusal(FileTrust::OwnFiles, PROVENANCE + " "), "something else");
    EXPECT_THROW(loadSquareOccupancy(file_, PROVENANCE), OccupancyFileError);
}

TEST_F(OccupancyFile, cutOrGrownIsRefused)
{
    for (std::size_t length = 0; length < bytes_.size(); length += length < 200 ? 1 : 97)
        EXPECT_NE(refusalOf(bytes_.substr(0, length), FileTrust::OwnFiles), "none") << length << " bytes";
    EXPECT_NE(refusalOf(bytes_.substr(0, bytes_.size() - 1), FileTrust::OwnFiles), "none");
    expectHolds(refusalOf(bytes_ + std::string(8, '\0')), "longer");
}

TEST_F(OccupancyFile, withAnyByteOfItsHeadChangedIsRefused)
{
    for (std::size_t at = 0; at < HEAD + PROVENANCE.size(); ++at)
        for (const char flips : {'\x01', '\x40'})
            EXPECT_NE(refusalOf(changed(at, flips), FileTrust::OwnFiles), "none") << "byte " << at;
}

TEST_F(OccupancyFile, withAnyWordChangedIsRefusedWhereItIsVerified)
{
    const std::size_t words = bytes_.size() - saved_->words().size() * 8;
    for (std::size_t at = words; at < bytes_.size(); at += 13)
        expectHolds(refusalOf(changed(at)), "damaged");
    // the frame, on which the searches rely, is looked at in any case
    expectHolds(refusalOf(changed(words), FileTrust::OwnFiles), "outside the lattice");
}

TEST_F(OccupancyFile, foreignFilesAreToldApart)
{
    expectHolds(refusalOf(std::string(5000, 'x')), "does not begin like one");
    expectHolds(refusalOf(""), "too short");
    expectHolds(refusalOf(changed(12, 3)), "version 2");
    std::string swapped = bytes_;
    std::reverse(swapped.begin() + 8, swapped.begin() + 12);
    expectHolds(refusalOf(swapped), "byte order");
    fs::remove(file_);
    expectHolds(refusal(), "can't be read");
    EXPECT_THROW(loadHexOccupancy(folder_.path(), PROVENANCE), OccupancyFileError);
    EXPECT_THROW(saveOccupancy(folder_ / "no" / "such" / "folder", *saved_, PROVENANCE), OccupancyFileError);
}

}  // namespace
