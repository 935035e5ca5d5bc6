// SPDX-License-Identifier: GPL-3.0-or-later
//
// Free space between bodies. Distant bodies stay distant for many motions: a free distance is
// proven once, then only the possible travel since is added up.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/machine/relative.h"

#include "rigid_body.h"

#include <array>
#include <optional>
#include <tuple>

namespace ncsim::verify {

/// Value by the letter of the joint.
using JointValues = std::array<double, std::tuple_size_v<machine::Values>>;

/// Free space between two bodies with the joints at `at`: the distance is proven to be at least
/// `apart_mm`; 0: the bodies may touch. As long as no point of a body has moved farther than
/// `apart_mm` relative to the observer, a joint motion of 1 (mm or degree) moves the point by at
/// most `of_body`, and a point of the observer relative to the body by at most `of_observer`.
struct FreeSpace {
    machine::Values at{};
    double apart_mm = 0.0;
    JointValues of_body{}, of_observer{};
};
/// Measures the free space. `way` is PairOnLeg::way; the distance is limited to `most_mm`.
FreeSpace free_space(const machine::Chain& way, const machine::Values& at,
                     const RigidBody& observer, const RigidBody& body, const cda::Lattice& lattice,
                     double most_mm);

/// Bounds of joint motions from the time of the proof to the start of a leg, and in the leg; mm and
/// degrees. X, Y and Z in the leg are separate (`straight`), with a bound for the three together.
struct JointMotionBounds {
    JointValues ways{};
    std::array<double, 3> straight{};
    double all_straight = 0.0;
};
/// Returns the joint motions from `begin`; `from`: start of the leg. Empty if unknown.
std::optional<JointMotionBounds> joint_motion_bounds(
    const machine::Values& begin, const std::optional<machine::Values>& from,
    const std::optional<machine::JointMotion>& leg);
/// True if more than `needed_mm` remains between the bodies during such motions.
bool stays_separated(const FreeSpace& space, const JointMotionBounds& ways, double needed_mm);

}  // namespace ncsim::verify
