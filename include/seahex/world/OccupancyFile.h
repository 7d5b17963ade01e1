#pragma once

#include <seahex/world/Occupancy.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace seahex
{

// Occupancies in files of their own, so that a second run need not build them again.
//
// A file holds a head, a text that says what the occupancy was made of, and the words as they lie in memory, so that
// they are used in place. Integers and floating point numbers are those of the machine that wrote it, behind a mark of
// the byte order:
//
//     0  "SEAHEXOC"                        40  f64 pitch
//     8  u32 0x01020304                    48  i64 columns, i64 rows
//    12  u32 version of the format, 1      64  u64 number of words
//    16  u32 corners of a cell, 6 or 4     72  u64 CRC-64 of the words
//    20  u32 length of the provenance      80  u64 CRC-64 of bytes 0 to 79 and of the provenance
//    24  f64 north-west corner x, y        88  the provenance; at the next multiple of 4096 the words, to the end
//
// CRC-64 is that of ECMA-182, which finds every burst of up to 64 bits.

/// A file that is not what it should be, in one sentence that names it.
struct OccupancyFileError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// How far to trust a file.
enum class FileTrust
{
    Verify,   ///< compare the checksum of the words: they are all read for that
    OwnFiles  ///< of the words only the frame is looked at, on which the searches rely
};

/// Writes a file that others see whole or not at all: under a name of its own first. A process that has an older file
/// of that name mapped keeps the old one.
/// @param provenance  what the occupancy was made of: all that would make it another one if it changed
/// @throws OccupancyFileError if it can't be written
void saveOccupancy(const std::filesystem::path &file, const Occupancy &occupancy, const std::string &provenance);

/// Does a file begin like one that saveOccupancy() writes? Tells a damaged or outdated one from somebody else's file.
bool isOccupancyFile(const std::filesystem::path &file);

/// What a file says that it was made of.
/// @throws OccupancyFileError as loadOccupancy()
std::string readProvenance(const std::filesystem::path &file);

/// Maps a file; its words are read when they are used, and shared by all processes that map it. The file must not be
/// written into while it is mapped (saveOccupancy() does not).
/// @param provenance  what the occupancy must have been made of, to the letter
/// @throws OccupancyFileError if it can't be read; is no such file, or of another version, byte order or kind of cells;
///         is cut or damaged; or was made of something else
std::shared_ptr<const HexOccupancy> loadHexOccupancy(const std::filesystem::path &file, const std::string &provenance,
                                                     FileTrust trust = FileTrust::Verify);
std::shared_ptr<const SquareOccupancy> loadSquareOccupancy(const std::filesystem::path &file,
                                                           const std::string &provenance,
                                                           FileTrust trust = FileTrust::Verify);

}  // namespace seahex
