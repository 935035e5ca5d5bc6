// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random programs of grooves: passes with vertical lead-in arcs, grooves that wind around a bar or
// into a block, and grooves of balls that cross.
#pragma once

#include <cstdint>
#include <string>

namespace ncsim::brep::test {

/// First seed of grooves; slot_parts.h has the seeds below.
inline constexpr std::uint64_t kGrooves = 10'000'000;

/// Returns the program of `seed`, the same in every call. Comments in the program describe tools
/// and stock.
std::string groove_part(std::uint64_t seed);

}  // namespace ncsim::brep::test
