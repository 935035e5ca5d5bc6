// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds on the distance between the hull of two poses of a rotating tool and the sweep of the tool
// between them.
//
// A round tool goes from pose A to pose B. T is the tip and a the direction of the axis, with the
// pose as index. A rotation about its own axis does not change a round tool. So let B be the pose
// for which the rotation from A to B is the least; its axis k is perpendicular to a_A and a_B. With
// s = |a_B - a_A|, w the direction of a_B - a_A and m the direction of a_A + a_B, a point of the
// tool at height z above the tip and at u along the direction in which the axis leans moves by
// exactly
//
//     V = D + s (z w - u m),    D = T_B - T_A.
//
// **Missed.** The point of a hull that belongs to a point q of the tool at time t lies on the chord
// of q. Its distance from q is at most an eighth of the largest acceleration of q.
//
// **Gained.** A point x of the hull is (1-t) A q1 + t B q2, with q1 and q2 in one convex piece; so
// q = (1-t) q1 + t q2 is in the same piece. At t, the chord of q is |t (1-t) (V(q1) - V(q2))| away
// from x: the distance of x from the tool at t is at most s/4 times the extent of the piece across
// k. If all points of the tool move the same way along w, by v1 and v2 at the ends of the axis,
// then q is nearer to x at another time, t' = t V_w(q2)/V_w(q). This t' is between 0 and 1, because
// V_w depends on z alone. The remaining distance is across w, the sum of
//
//     (t' - t) (D_across - s u m),    t' - t at most (√v2 - √v1)/(√v2 + √v1),    and
//     s t (1-t) (u1 - u2) m.
//
// The error of the chord is added, as above.
//
// **Cylinders.** Height and width do not add up. Let δ be the angle between the axis at t and m: |t
// - 1/2| times the angle of rotation, plus the bend. The offset of x from q is at most
//
//     s t (1-t) (|z1-z2| + δ |u1-u2|)  across the axis at t, and
//     s t (1-t) (|u1-u2| + δ |z1-z2|)  along the axis.
//
// The product t (1-t) δ is at most a twentieth of the angle of rotation plus a 32nd of the bend. If
// x is at the side of the tool, the gain is the first term. The point x is beyond an end, say the
// lower end, only if the height (1-t) z1 + t z2 of q above that end is less than the second term.
// Then
//
//     z1 < s t (2R + δ height),    z2 < s (1-t) (2R + δ height),    so
//     |z1-z2| < s max(t, 1-t) (2R + δ height).
//
// The first term is then of second order, because t (1-t) max(t, 1-t) is less than 0.149; it is
// perpendicular to the second term.
//
// **Rounded tools.** If the tool is the sum of a core and a ball (ball nose: the core is a part of
// the axis; corner radius: the cylinder within the corner), only the core counts, because a rotated
// ball is a ball. This fails at an upper end where the piece is cut off flat. It holds if this end
// is outside the region that matters.
//
// For a core K and a ball of radius ρ: x = (1-t) A (k1 + b1) + t B (k2 + b2) is within ρ of y =
// (1-t) A k1 + t B k2, and y is within the gain g of K from the tool's K at t. So x is within g of
// K + ball at t. The gain is g if K + ball is part of the tool over the heights of the places that
// matter: K + ball reaches down to the lower end of K less ρ, and x lies at most g below that.
//
// **Slabs.** The gain of a long tool grows with its length if its ends move in opposite directions.
// A piece may be cut across its axis into slabs. Each slab leaves a hull of its own, which gains
// less because the slab is shorter. All hulls together miss no more, because each follows its part.
// The gain is measured from the whole tool. A slab of a cylinder, from height z1 to z2 and of
// radius R, lies in K + ball for K from z1 to z2 of radius R - ρ; this is part of the tool if the
// tool is a cylinder from z1 - ρ to z2 + ρ. The lowest slab has the ball of the corner if the tool
// continues above by at least the ball's radius. The highest slab counts as rounded if no place
// that matters is as high as its end. The bounds hold only for the slabs of slabs_of(), so the code
// that makes the hulls has to cut at the same heights.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/toolpath/tool.h"
#include "ncsim/toolpath/tool_pose.h"

#include <limits>
#include <vector>

namespace ncsim::toolpath {

/// Dimensions of a piece of a tool that matter for rotations; mm, heights above the tip.
struct PieceExtent {
    double low_mm = 0.0, high_mm = 0.0;
    double radius_mm = 0.0;  ///< Largest radius.
    /// Core around which a ball rolls to make the piece. A piece with sharp edges is its own core.
    double core_low_mm = 0.0, core_high_mm = 0.0, core_radius_mm = 0.0;
    bool is_core_cylinder = false;
    /// True if the piece ends flat at the end of the core, where the ball is cut off.
    bool open_above = false;
    /// Height above which the piece is a cylinder, which may be cut off anywhere; high_mm if there
    /// is no cylinder.
    double straight_mm = 0.0;
    bool operator==(const PieceExtent&) const = default;
};
/// Returns the dimensions of `piece`.
PieceExtent extent_of(const ToolPiece& piece);

/// Pieces that count. Without pieces the tool is a point, the tip.
struct ToolExtent {
    std::vector<PieceExtent> pieces;
    bool operator==(const ToolExtent&) const = default;
};
/// Returns the dimensions of the cutting pieces of `tool`.
ToolExtent extent_of(const Tool& tool);

/// Returns the height above the tip, mm, up to which `piece` has to be kept if only places below
/// `top_mm` matter. The height includes a margin of 1 mm, so the gain at a new upper end is outside
/// these places.
double cut_off(const PieceExtent& piece, double top_mm);
/// True if `piece` can be left out completely.
bool is_above(const PieceExtent& piece, double top_mm);
/// Returns `tool` with all pieces cut off by cut_off().
ToolExtent below(ToolExtent tool, double top_mm);

/// Height range of a slab, mm above the tip.
struct Slab {
    double low_mm = 0.0, high_mm = 0.0;
};
/// Cuts `piece` into slabs, the lowest first. The first slab contains the part that is not a
/// cylinder. The cylinder is divided into equal heights of at most `slab_mm`; each further slab
/// overlaps the slab below a little.
std::vector<Slab> slabs_of(const PieceExtent& piece, double slab_mm);
/// Returns `tool` with all pieces cut into slabs. Requires: below() was applied first.
ToolExtent split_into_slabs(const ToolExtent& tool, double slab_mm);

/// Bounds on the rotation and translation of the tool in one step, between two poses. In mm and
/// radians.
struct RotationBounds {
    static constexpr double kInf = std::numeric_limits<double>::infinity();

    double turn_rad = 0.0;  ///< Sum over the rotary axes.
    double tilt_rad = 0.0;  ///< Length of the path of the tool axis' direction on the unit sphere.
    double tilt_bend_rad = 0.0;  ///< Acceleration of the tool axis' direction, per step².
    double moved_mm = 0.0;       ///< Length of the tip's path in the rotating frame.
    double chord_mm = 0.0;       ///< Distance between an arc and its chord.
    /// Distance of the tip from the rotary axis that moves; from the origin if several move.
    double tip_mm = 0.0;
    /// Largest sine of the angle between the tool axis and the rotary axis that moves; 1 if several
    /// move.
    double lean = 1.0;
    /// Largest distance of a place that matters from that rotary axis (the origin if several move),
    /// mm.
    double place_mm = kInf;
    /// Height above the tip, mm, below which all places that matter lie that are within kSideMargin
    /// of the tool, at any time of the motion.
    double top_mm = kInf;
    static constexpr double kSideMargin = 1.0;  ///< mm, across the axis, from the thickest piece.
    /// Largest height of the slabs whose hulls the tool leaves, mm.
    double slab_mm = kInf;

    /// Returns the bounds for the same tool, mounted `distance_mm` higher.
    RotationBounds raise_tool(double distance_mm) const;
};

/// Returns an upper bound, in mm, of the sweep beyond the hull at the places that matter, without
/// chord_mm. Valid for any angle.
double missed_mm(const RotationBounds& turning, const ToolExtent& tool);
/// Returns an upper bound, in mm, of the hull beyond the sweep at the places that matter, without
/// chord_mm. Valid for any angle.
double gained_mm(const Pose& X_WA, const Pose& X_WB, const RotationBounds& turning,
                 const ToolExtent& tool);

}  // namespace ncsim::toolpath
