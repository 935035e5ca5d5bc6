// SPDX-License-Identifier: GPL-3.0-or-later
//
// Poses along a motion. Between two successive poses the tool is taken to leave the convex
// hull of both behind; here is bounded by how much that differs from what it does.
#pragma once

#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/machine.h"
#include "ncsim/toolpath/pose.h"
#include "ncsim/toolpath/turning.h"

#include <cstdint>
#include <optional>
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

/// Largest distances, in mm, between the sweep of the tool and the union of the hulls, at the
/// places that matter. Both 0 for a straight motion that does not turn the tool.
struct SampleBounds {
    double missed_mm = 0.0;  ///< Of the sweep beyond the hulls.
    double gained_mm = 0.0;  ///< Of the hulls beyond the sweep.
    bool operator==(const SampleBounds&) const = default;
};

struct Samples {
    std::vector<Pose> poses;  ///< From start to end, at least two for a move; X_WT.
    SampleBounds bounds;      ///< Of all steps.
    Turning turning;          ///< Of each of them.
};

/// Poses at equal steps of the motion's parameter, the first and the last exactly its ends; none
/// for dwells and tool changes. What happens outside of `place` (mm, W) does not matter, and what
/// of the tool is above samples.turning.top_mm does not come there: a tool that turns is taken to
/// be cut off above it, as cut_off() says, and into slabs, as in_slabs() says for
/// samples.turning.slab_mm.
///
/// Arcs, helices and spirals: chords, where r is the largest radius, δ the angle of a step (rad)
/// and Δr the change of radius in it: both bounds are (r δ² + 2 Δr δ)/8, for the tool's centre line
/// and so for every tool that does not turn.
///
/// Where the tool turns, what turning.h says is added: as many steps as keep it, first of all the
/// chords of what turns: (θ²ρ + 2 θ s)/8 for θ in a step, ρ the distance from the axis and s the
/// distance moved in the rotating frame.
///
/// On a machine that somebody `told` (else null) the rotary axes may lie anywhere: θ is the sum of
/// all, ρ the largest distance of the tip, over the motion, from an axis that turns, and of the
/// rest of the tool by its reach more. For x = E1(t) … En(t) y, with turns by θ_i and ways by v_j,
///
///     |x″| ≤ Σ_i Σ_k θ_i θ_k d + 2 Σ_i θ_i Σ_j v_j,  d the distance from the axis of the inner
///     one.
///
/// Where the tip is programmed it goes straight in W (or on its arc), and the tool turns about it:
/// θ²·reach/8, and turns of a round tool about its own axis count for nothing. U, V and W move it
/// from there, by no more than ρ and on a way s in the frame that turns: (θ²(reach + ρ) + 2 θ s)/8.
///
/// Splines: steps are halved until the curve lies within half the chord tolerance of each chord at
/// a quarter, the half and three quarters of it: tested there, not proved between.
Samples sample(const gcode::Motion& motion, const ToolExtent& tool, const SamplingOptions& options,
               const std::optional<cda::Box>& place = {}, const Kinematics* told = nullptr);

/// How far a point of a tool that reaches no farther from its tip than `reach_mm` may get from
/// where it is at both ends of a straight move or an arc, mm; but for turns of the tool about
/// itself. `poses` are those of the motion. Cheap, and more than the truth. Nothing of splines.
std::optional<double> strays_mm(const gcode::Motion& motion, const Poses& poses, double reach_mm);

}  // namespace ncsim::toolpath
