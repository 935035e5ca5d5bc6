// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random programs of slots at any angle: arcs with plunges at their ends, lead-ins, slots that
// cross and passes side by side. Numbers have three to six decimals, millimetres or inches, and
// flat end mills are 0.1 to 20 mm wide.
#pragma once

#include <cstdint>
#include <string>

namespace ncsim::brep::test {

/// First seed of slots; cam_parts.h has the seeds below.
inline constexpr std::uint64_t kSlots = 9'000'000;

/// Returns the program of `seed`, the same in every call. Comments in the program describe tools
/// and stock.
std::string slot_part(std::uint64_t seed);

}  // namespace ncsim::brep::test
