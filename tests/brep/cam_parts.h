// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random programs in the style of CAM systems: walls and pockets in several passes with lead-in and
// lead-out arcs, entries by ramps and helices, facing, slots, holes, chamfers and engraving. Some
// straight moves are split into collinear pieces.
#pragma once

#include <cstdint>
#include <string>

namespace ncsim::brep::test {

/// First seed of CAM-style programs among the seeds of ncsim_brep_random.
inline constexpr std::uint64_t kCam = 7'000'000;
/// First seed of rotated CAM-style programs: the programs of `kCam`, rotated about the middle of
/// the block, with coordinates rounded again. The rounding separates faces that were coplanar.
inline constexpr std::uint64_t kTurnedCam = 8'000'000;

/// Returns the program of `seed`, the same in every call. Comments in the program describe tools
/// and stock.
std::string cam_part(std::uint64_t seed);

}  // namespace ncsim::brep::test
