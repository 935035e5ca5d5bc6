// SPDX-License-Identifier: GPL-3.0-or-later
//
// Poses along a motion. Between two successive poses the tool is taken to leave the convex
// hull of both behind; here is bounded by how much that differs from what it does.
#pragma once

#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/pose.h"
#include "ncsim/toolpath/tool.h"

#include <cstdint>
#include <vector>

namespace ncsim::toolpath {

/// In mm. What is chosen; what came out of it is in SampleBounds.
struct SamplingOptions {
    double chord_tolerance_mm = 0.005;  ///< Arcs, helices, spirals, splines: path and chord.
    double rotation_miss_mm = 0.005;    ///< Of the sweep of a turning tool, beyond the hulls.
    double rotation_gain_mm = 0.05;     ///< Of the hulls, beyond the sweep of a turning tool.
    /// A motion is never cut into more pieces; the bounds then say what that means.
    std::uint32_t max_steps = 100000;
};

/// How big the cutting part of a tool is, as far as rotations ask.
struct ToolExtent {
    double reach_mm = 0.0;   ///< Farthest cutting point from the tip.
    double across_mm = 0.0;  ///< Farthest two cutting points of one piece from each other.
};
ToolExtent extent_of(const Tool& tool);

/// Largest distances, in mm, between the sweep of the tool and the union of the hulls. Both 0 for
/// a straight motion that does not turn the tool.
struct SampleBounds {
    double missed_mm = 0.0;  ///< Of the sweep beyond the hulls.
    double gained_mm = 0.0;  ///< Of the hulls beyond the sweep.
    bool operator==(const SampleBounds&) const = default;
};

/// The smallest box (mm) around the path of the linear axes, X + U, Y + V, Z + W: what the travels
/// of a machine are compared with. To rounding for lines, arcs and helices; of spirals no more than
/// 1e-9 mm larger; of splines the box of their control points, which contains them. Empty for
/// dwells and tool changes.
cda::Box extent_of_path(const gcode::Motion& motion);

struct Samples {
    std::vector<Pose> poses;  ///< From start to end, at least two for a move; X_WT.
    SampleBounds bounds;
};

/// Poses at equal steps of the motion's parameter, the first and the last exactly its ends; none
/// for dwells and tool changes.
///
/// Arcs, helices and spirals: chords, where r is the largest radius, δ the angle of a step (rad)
/// and Δr the change of radius in it: both bounds are (r δ² + 2 Δr δ)/8, for the tool's centre line
/// and so for every tool that does not turn.
///
/// Rotations by θ in a step, ρ the largest distance of a tool point from the axis, D = across_mm
/// and s the distance moved in the rotating frame: missed (θ²ρ + 2 θ s)/8, gained θ D/4 more. θ is
/// the sum of the steps of A, B and C, which is never less than the angle between the poses.
///
/// Splines: steps are halved until the curve lies within half the chord tolerance of each chord at
/// a quarter, the half and three quarters of it: tested there, not proved between.
Samples sample(const gcode::Motion& motion, const ToolExtent& tool, const SamplingOptions& options);

}  // namespace ncsim::toolpath
