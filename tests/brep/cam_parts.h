// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs at random as CAM systems write them: walls and pockets in several passes down, with
// arcs that lead in and out, entries by ramps and helices, facing, slots, holes, chamfers and
// engraving; and straight moves in pieces that go on one as the other.
#pragma once

#include <cstdint>
#include <string>

namespace ncsim::brep::test {

/// Seeds of ncsim_brep_random from here on.
inline constexpr std::uint64_t kCam = 7'000'000;
/// From here on those of kCam, turned about the middle of the block, with numbers rounded again:
/// what lay in one plane is apart by as much.
inline constexpr std::uint64_t kTurnedCam = 8'000'000;

/// Always the same for a seed. Tools and stock are in its comments.
std::string cam_part(std::uint64_t seed);

}  // namespace ncsim::brep::test
