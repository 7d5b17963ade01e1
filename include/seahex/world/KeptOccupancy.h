#pragma once

#include <seahex/world/Occupancy.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace seahex
{

/// An occupancy that is kept in a file between runs: taken from there if the file holds it, else made and put there.
struct KeptOccupancy
{
    std::shared_ptr<const HexOccupancy> occupancy;
    bool isFromFile = false;            ///< the file's words, mapped; else made anew
    std::vector<std::string> warnings;  ///< each one sentence that names the file
};

/// Maps a file whose provenance is the given one to the letter and whose checksums are right. In every other case the
/// occupancy is made, and written for the next run:
/// - a file that was made of something else is replaced without a word;
/// - one that is damaged, or of another version or byte order, is replaced with a warning;
/// - one that saveOccupancy() did not begin is left alone, with a warning, and the occupancy is not kept; an empty one
///   is nobody's;
/// - where the file can't be written a warning says so.
/// Programs may share a file: each sees a whole one, and the last to finish writing keeps its own.
/// @param make  may throw, which leaves the file as it was
KeptOccupancy loadOrMake(const std::filesystem::path &file, const std::string &provenance,
                         const std::function<std::shared_ptr<const HexOccupancy>()> &make);

}  // namespace seahex
