// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs at random that lean the tool or the part: in planes of G68.2, under tip control, and on
// tables that were indexed, on machines that somebody told.
#pragma once

#include "ncsim/simulation/plan.h"

#include <cstdint>
#include <string>

namespace ncsim::brep::test {

struct TiltedPart {
    std::string machine;  ///< A preset.
    std::string program;  ///< Tools and stock are in its comments.
};

/// Seeds of ncsim_brep_random from here on, up to kWithSlopes.
inline constexpr std::uint64_t kTilted = 3'000'000;

/// Always the same for a seed.
TiltedPart tilted_part(std::uint64_t seed);

/// To cut it on its machine, with the boundary kept.
simulation::Plan plan_of(const TiltedPart& part, const std::string& name);

}  // namespace ncsim::brep::test
