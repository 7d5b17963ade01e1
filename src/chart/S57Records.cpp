#include "S57Records.h"

#include "seahex/chart/ChartError.h"

#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>

#include <cpl_vsi.h>

#include <cstdint>

namespace seahex
{
namespace
{

constexpr std::size_t LEADER_SIZE = 24;
constexpr std::size_t TAG_SIZE = 4;

/// A number in decimal digits; empty if it is none.
std::optional<std::size_t> digits(std::string_view text)
{
    std::size_t value = 0;
    for (const char digit : text)
    {
        if (digit < '0' || digit > '9')
            return std::nullopt;
        value = 10 * value + static_cast<std::size_t>(digit - '0');
    }
    return text.empty() ? std::nullopt : std::optional(value);
}

/// One record: its leader, its directory (tag, length and place of every field) and the fields.
class Record
{
public:
    /// The record at the beginning of the bytes; empty if none is whole.
    static std::optional<Record> at(std::string_view bytes)
    {
        if (bytes.size() < LEADER_SIZE)
            return std::nullopt;
        const auto length = digits(bytes.substr(0, 5));
        if (!length || *length < LEADER_SIZE || *length > bytes.size())
            return std::nullopt;
        return Record(bytes.substr(0, *length));
    }

    std::size_t size() const { return bytes_.size(); }
    bool isDescription() const { return bytes_[6] == 'L'; }
    bool isData() const { return bytes_[6] == 'D'; }

    /// The tag of the field that follows the record's number and tells its kind; empty if the directory is damaged.
    std::string_view keyTag() const
    {
        const std::string_view entry = keyEntry();
        return entry.substr(0, entry.empty() ? 0 : TAG_SIZE);
    }

    /// The first byte of that field: in S-57 the name of the kind of record.
    std::optional<int> keyName() const
    {
        const auto base = digits(bytes_.substr(12, 5));
        const auto place = digits(keyEntry().substr(entrySize() - placeSize()));
        if (!base || !place || *base + *place >= bytes_.size())
            return std::nullopt;
        return static_cast<unsigned char>(bytes_[*base + *place]);
    }

private:
    explicit Record(std::string_view bytes) : bytes_(bytes) {}

    static std::size_t digit(char c) { return c >= '1' && c <= '9' ? static_cast<std::size_t>(c - '0') : 0; }
    std::size_t placeSize() const { return digit(bytes_[21]); }
    std::size_t entrySize() const { return TAG_SIZE + digit(bytes_[20]) + placeSize(); }

    /// The second entry of the directory.
    std::string_view keyEntry() const
    {
        const std::size_t begin = LEADER_SIZE + entrySize();
        const bool isWhole = digit(bytes_[20]) > 0 && placeSize() > 0 && digit(bytes_[23]) == TAG_SIZE &&
                             begin + entrySize() <= bytes_.size() && bytes_.substr(LEADER_SIZE, TAG_SIZE) == "0001";
        return isWhole ? bytes_.substr(begin, entrySize()) : std::string_view();
    }

    std::string_view bytes_;
};

// S-57's names of the kinds of records.
constexpr int FEATURE = 100;

bool isSpatial(int name)
{
    return name == 110 || name == 120 || name == 130 || name == 140;
}

/// A file in memory for as long as the object lives.
class MemoryFile
{
public:
    explicit MemoryFile(const std::string &bytes)
        : path_("/vsimem/seahex/" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) + "/HEAD.000"), bytes_(bytes)
    {
        VSIFCloseL(VSIFileFromMemBuffer(path_.c_str(), reinterpret_cast<GByte *>(bytes_.data()), bytes_.size(), FALSE));
    }
    ~MemoryFile() { VSIUnlink(path_.c_str()); }
    MemoryFile(const MemoryFile &) = delete;
    MemoryFile &operator=(const MemoryFile &) = delete;

    const std::string &path() const { return path_; }

private:
    std::string path_;
    std::string bytes_;
};

}  // namespace

std::optional<S57Records> S57Records::of(const std::filesystem::path &file)
{
    namespace bi = boost::interprocess;
    try
    {
        const bi::file_mapping mapping(file.c_str(), bi::read_only);
        const bi::mapped_region bytes(mapping, bi::read_only);
        S57Records records;
        if (records.scan({static_cast<const char *>(bytes.get_address()), bytes.get_size()}))
            return records;
    }
    catch (const bi::interprocess_exception &)
    {
    }
    return std::nullopt;
}

bool S57Records::scan(std::string_view rest)
{
    for (bool isFirst = true; !rest.empty(); isFirst = false)
    {
        const std::optional<Record> record = Record::at(rest);
        if (!record || !(isFirst ? record->isDescription() : record->isData()))
            return false;
        const std::string_view tag = isFirst ? std::string_view() : record->keyTag();
        const bool isHead = isFirst || tag == "DSID" || tag == "DSPM";
        if (isHead)
        {
            if (counts_.features + counts_.spatials > 0)
                return false;
            head_.append(rest.substr(0, record->size()));
        }
        else if (tag == "FRID" && record->keyName() == FEATURE)
            ++counts_.features;
        else if (tag == "VRID" && isSpatial(record->keyName().value_or(0)))
            ++counts_.spatials;
        else
            return false;
        rest.remove_prefix(record->size());
    }
    return true;
}

std::optional<S57Header> S57Records::header() const
{
    const DriverMessages messages;
    const MemoryFile head(head_);
    const GdalDataset dataset = openVector(head.path(), {"S57"}, {"UPDATES=IGNORE"});
    if (!dataset)
        return std::nullopt;
    try
    {
        return readS57Header(*dataset, head.path());
    }
    catch (const ChartDamaged &)
    {
        return std::nullopt;
    }
}

}  // namespace seahex
