// SPDX-License-Identifier: GPL-3.0-or-later
//
// Poses along a motion. The simulation assumes that between two successive poses the tool removes
// the convex hull of both; the bounds here limit the distance between these hulls and the true
// sweep.
#pragma once

#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/kinematics.h"
#include "ncsim/toolpath/rotation_bounds.h"
#include "ncsim/toolpath/tool_pose.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::toolpath {

/// Chosen limits, in mm. SampleBounds has the limits that were reached.
struct SamplingOptions {
    /// Between path and chord, for arcs, helices, spirals and splines.
    double chord_tolerance_mm = 0.005;
    /// Largest part of a rotating tool's sweep outside the hulls.
    double rotation_miss_mm = 0.005;
    double rotation_gain_mm = 0.05;  ///< Largest part of the hulls outside a rotating tool's sweep.
    /// Largest number of pieces of a motion. If it limits the sampling, the bounds are larger.
    std::uint32_t max_steps = 100000;
};

/// Largest distances, in mm, between the sweep of the tool and the union of the hulls, at the
/// places that matter. Both are 0 for a straight motion without rotation of the tool.
struct SampleBounds {
    double missed_mm = 0.0;  ///< Sweep beyond the hulls.
    double gained_mm = 0.0;  ///< Hulls beyond the sweep.
    bool operator==(const SampleBounds&) const = default;
};

/// Result of sample().
struct Samples {
    std::vector<Pose> poses;  ///< X_WT from start to end, at least two for a move.
    SampleBounds bounds;      ///< Bounds over all steps.
    RotationBounds turning;   ///< Bounds on the rotation in each step.
};

/// Returns poses at equal steps of the motion's parameter. The first and the last pose are exactly
/// the ends. Empty for dwells and tool changes. Only places inside `place` (mm, W) matter. The part
/// of the tool above samples.turning.top_mm does not reach these places. A rotating tool is assumed
/// to be cut off above that height, as by cut_off(), and cut into slabs, as by split_into_slabs()
/// with samples.turning.slab_mm.
///
/// Arcs, helices and spirals become chords. With r the largest radius, δ the angle of a step (rad)
/// and Δr the change of radius in a step, both bounds are (r δ² + 2 Δr δ)/8 for the tool's centre
/// line, and so for every tool that does not rotate.
///
/// If the tool rotates, the bounds of rotation_bounds.h are added, and the number of steps is large
/// enough to keep them. The first bound is that of the chords of rotating points: (θ²ρ + 2 θ s)/8
/// with θ the angle of a step, ρ the distance from the axis and s the distance moved in the
/// rotating frame.
///
/// On a specified machine (last parameter, not null) the rotary axes may lie anywhere. θ is the sum
/// over all rotary axes. ρ is the largest distance of the tip, over the motion, from a rotary axis
/// that moves; for the rest of the tool, the tool's reach is added. For x = E1(t) … En(t) y, with
/// rotations by θ_i and translations by v_j,
///
///     |x″| ≤ Σ_i Σ_k θ_i θ_k d + 2 Σ_i θ_i Σ_j v_j
///
/// where d is the distance from the axis of the inner joint.
///
/// Under tip control the tip moves on a straight line in W (or on its arc), and the tool rotates
/// about the tip: θ²·reach/8. Rotations of a round tool about its own axis do not count. U, V and W
/// move the tip by at most ρ and along a path s in the rotating frame: (θ²(reach + ρ) + 2 θ s)/8.
///
/// Splines: steps are halved until the curve lies within half the chord tolerance of each chord at
/// a quarter, half and three quarters of the step. This is tested at these points, not proved
/// between them.
Samples sample(const gcode::Motion& motion, const ToolExtent& tool, const SamplingOptions& options,
               const std::optional<Box>& place = {}, const Kinematics* specified = nullptr);

/// Returns how far (mm) a point of the tool can get from its positions at both ends of a straight
/// move or an arc, rotation about the tool's own axis excepted. `reach_mm` is the largest distance
/// of a point of the tool from the tip; `poses` belongs to `motion`. The bound is fast to compute
/// and larger than the true distance. Empty for splines.
std::optional<double> max_deviation_mm(const gcode::Motion& motion, const Poses& poses,
                                       double reach_mm);

}  // namespace ncsim::toolpath
