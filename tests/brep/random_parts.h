// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs at random of what most programs are made of: level lines, flat arcs and holes, by end
// mills, balls, bull noses, V-cutters and drills; some of helices by end mills; some that finish
// waves with a ball; some of slopes and helices by balls and bull noses;
// some of balls that turn, and some of end mills that do and cut with their sides.
#pragma once

#include <cstdint>
#include <string>

namespace ncsim::brep::test {

/// Seeds from here on are of programs with end mills alone, half of whose arcs go down.
inline constexpr std::uint64_t kWithHelices = 1'000'000;
/// And from here on of finishing by a ball in rows.
inline constexpr std::uint64_t kRasters = 2'000'000;
/// And from here on (before are those of tilted_parts.h) of the three kinds of end mills, lines and
/// arcs up and down.
inline constexpr std::uint64_t kWithSlopes = 4'000'000;
/// And from here on of a ball in grooves, while B turns.
inline constexpr std::uint64_t kTurning = 5'000'000;
/// And from here on of the three kinds of end mills, deeper than their ends are high.
inline constexpr std::uint64_t kTurningSides = 6'000'000;

/// Always the same for a seed. Tools and stock are in its comments.
std::string random_part(std::uint64_t seed);

}  // namespace ncsim::brep::test
