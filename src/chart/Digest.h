#pragma once

#include <boost/crc.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

namespace seahex
{

/// CRC-64 (ECMA-182) of what is added: finds accidents, every change of up to 64 bits in a row among them; against
/// malice it is no help.
class Digest
{
public:
    void add(const void *bytes, std::size_t size) { crc_.process_bytes(bytes, size); }
    /// Bit for bit, so that even 0 and -0 differ.
    void add(double value) { add(&value, sizeof value); }
    void add(std::uint64_t value) { add(&value, sizeof value); }

    /// 16 hexadecimal digits.
    std::string text() const
    {
        char digits[17];
        std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(crc_.checksum()));
        return digits;
    }

private:
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~std::uint64_t{0}, 0, false, false> crc_;
};

}  // namespace seahex
