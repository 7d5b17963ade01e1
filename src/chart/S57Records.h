#pragma once

#include "GdalDataset.h"
#include "S57Header.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace seahex
{

/// The records of an S-57 file as its ISO 8211 leaders and directories tell of them, without a look at their fields.
///
/// The driver reads every spatial record with all of its coordinates to count it, and a whole cell to tell its header;
/// this does both in a fraction of the time.
class S57Records
{
public:
    /// @return empty if the file can't be read, or is in any way not as S-57 wants it: cut, records of unknown kinds or
    ///         in another order. What is wrong with it is then for the driver to say.
    static std::optional<S57Records> of(const std::filesystem::path &file);

    const S57Counts &counts() const { return counts_; }

    /// The file's header, read by the driver from the records that hold it; empty if the driver can't.
    std::optional<S57Header> header() const;

private:
    bool scan(std::string_view rest);

    S57Counts counts_;
    std::string head_;  ///< the records in front of the first spatial or feature record
};

}  // namespace seahex
