// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random programs that tilt the tool or the part: in planes of G68.2, under tip control, and on
// indexed tables, on machines with specified kinematics.
#pragma once

#include "ncsim/simulation/plan.h"

#include <cstdint>
#include <string>

namespace ncsim::brep::test {

struct TiltedPart {
    std::string machine;  ///< Name of a preset.
    std::string program;  ///< Program with comments that describe tools and stock.
};

/// First seed of tilted parts among the seeds of ncsim_brep_random; they end at `kWithSlopes`.
inline constexpr std::uint64_t kTilted = 3'000'000;

/// Returns the part of `seed`, the same in every call.
TiltedPart tilted_part(std::uint64_t seed);

/// Returns a plan that cuts the part on its machine and keeps the boundary.
simulation::Plan plan_of(const TiltedPart& part, const std::string& name);

}  // namespace ncsim::brep::test
