// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers and outlines as bytes, the least significant first, and back.
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

/// Reads what these write. All throw std::invalid_argument if it is not there or cannot be.
class TileBytes {
public:
    explicit TileBytes(std::string_view bytes) : bytes_(bytes) {}

    std::uint32_t u32();
    std::uint64_t u64();
    double number();
    /// Planes within the bits of the kernel, points where their planes meet, references to what
    /// there is: whatever is done with them is defined. O(size).
    Outlines outlines();
    /// The bytes of outlines; nobody has looked at them.
    std::string_view outlines_as_bytes();
    bool is_at_end() const { return bytes_.empty(); }

private:
    std::uint32_t count(std::size_t bytes_each);

    std::string_view bytes_;
};

}  // namespace ncsim::cda
