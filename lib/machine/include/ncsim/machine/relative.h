// SPDX-License-Identifier: GPL-3.0-or-later
//
// Relative motion of two bodies that a machine moves, each by its own joints: the pose of a body
// seen from another, and bounds of its motion.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/machine/chain.h"

#include <array>

namespace ncsim::machine {

/// Returns the joints between two bodies as a chain; the last joint is next to `body`. `observer`
/// and `body` are the joints that move each of the bodies, from the bed on, each joint as it moves
/// the body itself. Joints that carry both bodies are left out because they cause no relative
/// motion. The result is empty if the bodies are the same.
Chain seen_from(const Chain& observer, const Chain& body);

/// Returns the pose of a body that `moved_by` carries, relative to its pose with all joints at 0.
/// The pose includes the full rotation.
Pose pose_of(const Chain& moved_by, const Values& values);
/// Returns X_BA: p_B = inverse(X_AB) * p_A, to rounding.
Pose inverse(const Pose& X_AB);

/// Motion of the joints over a stretch whose parameter runs from 0 to 1. All joints except X, Y and
/// Z move linearly from `from` to `to`.
struct JointMotion {
    Values from{}, to{};
    std::array<double, 3> speed{};  ///< Bounds of the speeds of X, Y and Z, mm.
    double all_speed = 0.0;         ///< Bound of the speed of X, Y and Z together, mm.
    double bend = 0.0;              ///< Bound of the second derivative of X, Y and Z together, mm.
};

/// Ball that contains a body whose points already move, with bounds of their speed and their second
/// derivative. mm.
struct Ball {
    Vec3 centre;
    double radius = 0.0;
    double speed = 0.0, bend = 0.0;
};

/// Returns the ball after `chain` has moved the body over the stretch `joint_motion`. For a
/// rotation by θ about an axis at distance at most d, of points with speed v and second derivative
/// a,
///
///     |x'| <= θ d + v        |x''| <= θ² d + 2 θ v + a
///
/// joint by joint from the body on; X, Y and Z are perpendicular. Each point stays within `speed`
/// of its start, and within bend / 8 of the chord between its ends.
Ball move_ball(const Chain& chain, const JointMotion& joint_motion, Ball body);

}  // namespace ncsim::machine
