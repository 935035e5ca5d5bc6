// SPDX-License-Identifier: GPL-3.0-or-later
//
// Serialisation of numbers and outlines, the least significant byte first.
#pragma once

#include "surface/outlines.h"

#include <cstdint>
#include <iosfwd>
#include <string_view>

namespace ncsim::cda {

void put_u32(std::ostream& out, std::uint32_t value);
void put_u64(std::ostream& out, std::uint64_t value);
void put_double(std::ostream& out, double value);
void put_outlines(std::ostream& out, const Outlines& outlines);

/// Reader of the bytes that the functions above write. Throws: std::invalid_argument if data is
/// missing or invalid.
class TileBytes {
public:
    explicit TileBytes(std::string_view bytes) : bytes_(bytes) {}

    std::uint32_t u32();
    std::uint64_t u64();
    double number();
    /// Returns outlines whose planes have the bits of the kernel, whose points are where their
    /// planes meet, and whose references are valid. So any use of the outlines is well-defined.
    /// Cost: O(size).
    Outlines outlines();
    /// Returns the bytes of outlines without validation.
    std::string_view outlines_as_bytes();
    bool is_at_end() const { return bytes_.empty(); }

private:
    std::uint32_t count(std::size_t bytes_each);

    std::string_view bytes_;
};

}  // namespace ncsim::cda
