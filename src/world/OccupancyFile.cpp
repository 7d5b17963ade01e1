#include "seahex/world/OccupancyFile.h"

#include <boost/crc.hpp>
#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>

#include <cstddef>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>
#include <system_error>

namespace seahex
{
namespace
{

namespace fs = std::filesystem;
namespace bi = boost::interprocess;

constexpr char MAGIC[8] = {'S', 'E', 'A', 'H', 'E', 'X', 'O', 'C'};
constexpr std::uint32_t BYTE_ORDER_MARK = 0x01020304;
constexpr std::uint32_t SWAPPED_MARK = 0x04030201;
constexpr std::uint32_t VERSION = 1;
constexpr std::uint64_t WORDS_ALIGNMENT = 4096;
constexpr std::uint32_t HEXAGON = 6;
constexpr std::uint32_t SQUARE = 4;

/// The head as it lies in the file.
struct Head
{
    char magic[8];
    std::uint32_t byteOrder;
    std::uint32_t version;
    std::uint32_t corners;
    std::uint32_t provenanceSize;
    double northWestX;
    double northWestY;
    double pitch;
    std::int64_t columns;
    std::int64_t rows;
    std::uint64_t wordCount;
    std::uint64_t wordsChecksum;
    std::uint64_t headChecksum;
};
static_assert(sizeof(Head) == 88, "the head has no padding");

std::uint64_t wordsOffset(const Head &head)
{
    const std::uint64_t end = sizeof(Head) + head.provenanceSize;
    return (end + WORDS_ALIGNMENT - 1) / WORDS_ALIGNMENT * WORDS_ALIGNMENT;
}

using Crc64 = boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0, 0, false, false>;

std::uint64_t checksumOfWords(const std::uint64_t *words, std::size_t count)
{
    Crc64 crc;
    crc.process_bytes(words, count * sizeof(std::uint64_t));
    return crc.checksum();
}

std::uint64_t checksumOfHead(const Head &head, const char *provenance)
{
    Crc64 crc;
    crc.process_bytes(&head, offsetof(Head, headChecksum));
    crc.process_bytes(provenance, head.provenanceSize);
    return crc.checksum();
}

/// A file in the memory of this process, its head found right.
class MappedOccupancy
{
public:
    explicit MappedOccupancy(const fs::path &file) : name_("'" + file.string() + "'"), region_(map(file))
    {
        if (size() < sizeof(Head))
            refuse("is no occupancy: it is too short");
        std::memcpy(&head_, bytes(), sizeof(Head));
        if (std::memcmp(head_.magic, MAGIC, sizeof MAGIC) != 0)
            refuse("is no occupancy: it does not begin like one");
        if (head_.byteOrder == SWAPPED_MARK)
            refuse("was written on a machine of another byte order");
        if (head_.version != VERSION)
            refuse("is of version " + std::to_string(head_.version) + " of the format, and only version " +
                   std::to_string(VERSION) + " can be read");
        if (head_.byteOrder != BYTE_ORDER_MARK || head_.provenanceSize > size() - sizeof(Head) ||
            checksumOfHead(head_, bytes() + sizeof(Head)) != head_.headChecksum)
            refuse("has a damaged head");
        const std::uint64_t offset = wordsOffset(head_);
        if (size() < offset || (size() - offset) % sizeof(std::uint64_t) != 0 ||
            (size() - offset) / sizeof(std::uint64_t) != head_.wordCount)
            refuse("is cut, or longer than its head says");
    }

    const Head &head() const { return head_; }
    std::string provenance() const { return std::string(bytes() + sizeof(Head), head_.provenanceSize); }

    /// The region begins at a page, and the words at a multiple of a page's least size.
    const std::uint64_t *words() const
    {
        return static_cast<const std::uint64_t *>(
            static_cast<const void *>(static_cast<const char *>(region_.get_address()) + wordsOffset(head_)));
    }

    [[noreturn]] void refuse(const std::string &why) const { throw OccupancyFileError(name_ + " " + why); }

private:
    bi::mapped_region map(const fs::path &file) const
    {
        std::error_code error;
        const auto length = fs::file_size(file, error);
        if (error)
            refuse("can't be read: " + error.message());
        if (length == 0)  // which can't be mapped
            refuse("is no occupancy: it is too short");
        try
        {
            return bi::mapped_region(bi::file_mapping(file.c_str(), bi::read_only), bi::read_only);
        }
        catch (const bi::interprocess_exception &fault)
        {
            refuse(std::string("can't be read: ") + fault.what());
        }
    }

    const char *bytes() const { return static_cast<const char *>(region_.get_address()); }
    std::size_t size() const { return region_.get_size(); }

    std::string name_;
    bi::mapped_region region_;
    Head head_{};
};

/// The frame and the padding must be set, for the searches do not test bounds.
bool hasItsFrame(const CellLayout &layout, const std::uint64_t *words)
{
    const auto frame = CellLayout::frame;
    for (std::int64_t row = -frame; row < layout.rows() + frame; ++row)
    {
        const bool isInside = row >= 0 && row < layout.rows();
        const auto begin = static_cast<std::size_t>((row + frame) * layout.stride());
        for (std::int64_t i = 0; i < layout.stride(); ++i)
        {
            if (isInside && i == frame)
                i += layout.columns();
            const std::size_t index = begin + static_cast<std::size_t>(i);
            if (i < layout.stride() && (words[index >> 6] >> (index & 63) & 1) == 0)
                return false;
        }
    }
    return true;
}

template <class KnownLattice>
std::shared_ptr<const LatticeOccupancy<KnownLattice>> load(const fs::path &file, const std::string &provenance,
                                                           FileTrust trust, std::uint32_t corners)
{
    const auto mapped = std::make_shared<const MappedOccupancy>(file);
    const Head &head = mapped->head();
    if (head.corners != corners)
        mapped->refuse("holds cells of " + std::to_string(head.corners) + " corners, not " + std::to_string(corners));
    if (mapped->provenance() != provenance)
        mapped->refuse("was made of something else than what is asked for");
    try
    {
        const KnownLattice lattice(Point(head.northWestX, head.northWestY), head.pitch, head.columns, head.rows);
        const CellLayout layout(head.columns, head.rows);
        if (layout.wordCount() != head.wordCount)
            mapped->refuse("has a damaged head");
        if (trust == FileTrust::Verify && checksumOfWords(mapped->words(), layout.wordCount()) != head.wordsChecksum)
            mapped->refuse("is damaged: the checksum of its cells does not match");
        if (!hasItsFrame(layout, mapped->words()))
            mapped->refuse("is damaged: cells outside the lattice are free");
        return std::make_shared<const LatticeOccupancy<KnownLattice>>(
            lattice, layout, CellWords(mapped, mapped->words(), layout.wordCount()));
    }
    catch (const std::logic_error &)
    {
        mapped->refuse("holds an impossible lattice");
    }
}

fs::path partName(const fs::path &file)
{
    std::random_device device;
    std::ostringstream suffix;
    suffix << ".part-" << std::hex << device() << device();
    return file.string() + suffix.str();
}

}  // namespace

void saveOccupancy(const fs::path &file, const Occupancy &occupancy, const std::string &provenance)
{
    const Lattice &lattice = occupancy.lattice();
    const CellWords &words = occupancy.words();
    Head head{};
    std::memcpy(head.magic, MAGIC, sizeof MAGIC);
    head.byteOrder = BYTE_ORDER_MARK;
    head.version = VERSION;
    head.corners = lattice.hexagons() != nullptr ? HEXAGON : SQUARE;
    head.provenanceSize = static_cast<std::uint32_t>(provenance.size());
    head.northWestX = lattice.northWest().x();
    head.northWestY = lattice.northWest().y();
    head.pitch = lattice.pitch();
    head.columns = lattice.columns();
    head.rows = lattice.rows();
    head.wordCount = words.size();
    head.wordsChecksum = checksumOfWords(words.data(), words.size());
    head.headChecksum = checksumOfHead(head, provenance.data());

    std::string front(wordsOffset(head), '\0');
    std::memcpy(front.data(), &head, sizeof head);
    provenance.copy(front.data() + sizeof head, provenance.size());

    const fs::path part = partName(file);
    std::ofstream out(part, std::ios::binary);
    out.write(front.data(), static_cast<std::streamsize>(front.size()));
    out.write(static_cast<const char *>(static_cast<const void *>(words.data())),
              static_cast<std::streamsize>(words.size() * sizeof(std::uint64_t)));
    out.close();
    std::error_code error;
    if (out)
        fs::rename(part, file, error);
    if (!out || error)
    {
        std::error_code ignored;
        fs::remove(part, ignored);
        throw OccupancyFileError("'" + file.string() + "' can't be written");
    }
}

bool isOccupancyFile(const fs::path &file)
{
    char begin[sizeof MAGIC] = {};
    std::ifstream in(file, std::ios::binary);
    return in.read(begin, sizeof begin) && std::memcmp(begin, MAGIC, sizeof MAGIC) == 0;
}

std::string readProvenance(const fs::path &file)
{
    return MappedOccupancy(file).provenance();
}

std::shared_ptr<const HexOccupancy> loadHexOccupancy(const fs::path &file, const std::string &provenance,
                                                     FileTrust trust)
{
    return load<HexLattice>(file, provenance, trust, HEXAGON);
}

std::shared_ptr<const SquareOccupancy> loadSquareOccupancy(const fs::path &file, const std::string &provenance,
                                                           FileTrust trust)
{
    return load<SquareLattice>(file, provenance, trust, SQUARE);
}

}  // namespace seahex
