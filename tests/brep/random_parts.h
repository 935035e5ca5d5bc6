// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random programs of common operations. Level lines, flat arcs and holes are cut by end mills,
// balls, bull noses, V-cutters and drills. Some programs have helices of end mills, waves that a
// ball finishes, or slopes and helices of balls and bull noses. In some, B rotates a ball or an end
// mill that cuts with its side.
#pragma once

#include <cstdint>
#include <string>

namespace ncsim::brep::test {

/// First seed of programs with end mills alone, half of whose arcs descend.
inline constexpr std::uint64_t kWithHelices = 1'000'000;
/// First seed of finishing programs of a ball in rows.
inline constexpr std::uint64_t kRasters = 2'000'000;
/// First seed of programs of the three kinds of end mills with lines and arcs up and down. The
/// seeds of tilted_parts.h are below.
inline constexpr std::uint64_t kWithSlopes = 4'000'000;
/// First seed of programs of a ball in grooves while B rotates.
inline constexpr std::uint64_t kTurning = 5'000'000;
/// First seed of programs of the three kinds of end mills, deeper than their ends are high, while B
/// rotates.
inline constexpr std::uint64_t kTurningSides = 6'000'000;

/// Returns the program of `seed`, the same in every call. Comments in the program describe tools
/// and stock.
std::string random_part(std::uint64_t seed);

}  // namespace ncsim::brep::test
