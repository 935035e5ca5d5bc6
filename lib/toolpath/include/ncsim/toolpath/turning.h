// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the hull of two poses of a turning tool is from what the tool sweeps between them.
//
// A round tool that goes from pose A to pose B: T its tip, a the direction of its axis, both with
// the index of the pose. Of B any turn about its own axis leaves it as it is: let it be the one for
// which A turns into B by the least rotation, about k at right angles to both axes. With
// s = |a_B - a_A|, w the direction of a_B - a_A and m that of a_A + a_B, a point of the tool at
// height z above the tip and at u along the direction in which its axis leans moves by exactly
//
//     V = D + s (z w - u m),    D = T_B - T_A.
//
// **Missed.** The point of a hull that belongs to a point q of the tool at time t lies on the chord
// of q: it is off by an eighth of the largest acceleration of q.
//
// **Gained.** A point x of the hull is (1-t) A q1 + t B q2, with q1 and q2 in one convex piece, and
// so is q = (1-t) q1 + t q2. On its chord at t it is t (1-t) (V(q1) - V(q2)) away from x: the tool
// at t is no farther from x than s/4 times the extent of the piece across k. If all of the tool
// goes the same way along w, by v1 and v2 at the ends of its axis, then q comes nearer at another
// time: at t V_w(q2)/V_w(q), which is between 0 and 1, since V_w depends on z alone. Then what is
// left is across w: (t' - t) (D_across - s u m), where t' - t is at most (√v2 - √v1)/(√v2 + √v1),
// and s t (1-t) (u1 - u2) m. Add what the chord is off, as above.
//
// Of a cylinder, height and width do not count at once. Let δ be the angle of its axis at t and m:
// |t - 1/2| times the angle that it turns by, and what it bends. Then x is beside q by no more than
// s t (1-t) (|z1-z2| + δ |u1-u2|) across the axis at t, and by s t (1-t) (|u1-u2| + δ |z1-z2|)
// along it; t (1-t) δ is no more than a twentieth of that angle and a 32nd of the bend. Where x is
// only beside the tool, the first is what is gained. It is beyond an end, the lower one, only if q,
// at the height (1-t) z1 + t z2, is nearer to that than by the second: then z1 is less than s t (2R
// + δ height), z2 less than s (1-t) times as much, and so is |z1-z2| by the larger of t and 1-t.
// Which leaves of the first an amount of second order, t (1-t) times the larger one being less than
// 0.149; it is at right angles to the second.
//
// Where the tool is a body rolled around by a ball (a ball nose: an axis; a corner radius: the
// cylinder within the corner), the sum of a point of each, a ball turned is a ball: only the body
// within counts. That fails where the piece is cut off flat, at its upper end: it holds if this end
// is out of the region that matters.
//
// For a core K and a ball of radius ρ: x = (1-t) A (k1 + b1) + t B (k2 + b2) is within ρ of the
// same of k1 and k2, and that within the gain g of K of the tool's K at t. So x is within g of K +
// ball at t, and the gain is g if that is part of the tool, as far down and up as places are that
// matter: K + ball reaches down to the height of K less ρ, and x no lower than g below that.
//
// **Slabs.** What a long tool gains grows with its length where its ends go opposite ways. A piece
// may be cut across its axis: each slab leaves a hull of its own, which gains less, being shorter,
// and all together miss no more, since each follows its part. The gain is counted from the whole
// tool. A slab of a cylinder, from height z1 to z2 and of radius R, lies in K + ball for K from z1
// to z2 of radius R - ρ; this is part of the tool if that is a cylinder from z1 - ρ to z2 + ρ. The
// lowest slab has the ball of the corner, if the tool goes on above by as much; the highest is
// taken for rolled if no place that matters is as high as its end. All this holds for the very
// slabs that were told, so that what makes the hulls has to cut at the same heights.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/toolpath/pose.h"
#include "ncsim/toolpath/tool.h"

#include <limits>
#include <vector>

namespace ncsim::toolpath {

/// How big a piece of a tool is, as far as rotations ask; mm, heights above the tip.
struct PieceExtent {
    double low_mm = 0.0, high_mm = 0.0;
    double radius_mm = 0.0;  ///< The largest.
    /// Of the body that a ball rolls around to make the piece: the piece itself where it has edges.
    double core_low_mm = 0.0, core_high_mm = 0.0, core_radius_mm = 0.0;
    bool is_core_cylinder = false;
    /// It ends flat, where the core ends, too: the ball is cut off there.
    bool open_above = false;
    /// From here on it is a cylinder, which may be cut off anywhere; high_mm if there is none.
    double straight_mm = 0.0;
    bool operator==(const PieceExtent&) const = default;
};
PieceExtent extent_of(const ToolPiece& piece);

/// Of the pieces that count; without any it is a point, the tip.
struct ToolExtent {
    std::vector<PieceExtent> pieces;
    bool operator==(const ToolExtent&) const = default;
};
/// Of those that cut.
ToolExtent extent_of(const Tool& tool);

/// How high above the tip a piece has to be kept if only what lies lower than `top_mm` matters. A
/// millimetre more, so that what is gained at a new upper end is out of the way, too.
double cut_off(const PieceExtent& piece, double top_mm);
/// Nothing of it has to be kept.
bool is_above(const PieceExtent& piece, double top_mm);
/// With all pieces cut off there.
ToolExtent below(ToolExtent tool, double top_mm);

/// From where to where the slabs of a piece go, the lowest first: what is not a cylinder is part of
/// it, the others are equally high, no higher than `slab_mm`, and reach a little into the one
/// below.
struct Slab {
    double low_mm = 0.0, high_mm = 0.0;
};
std::vector<Slab> slabs_of(const PieceExtent& piece, double slab_mm);
/// With all pieces cut into slabs: first below(), then this.
ToolExtent in_slabs(const ToolExtent& tool, double slab_mm);

/// One step of a motion: bounds of how the tool turns and moves between two poses. mm, radians.
struct Turning {
    static constexpr double kInf = std::numeric_limits<double>::infinity();

    double turn_rad = 0.0;       ///< Sum over the rotary axes.
    double tilt_rad = 0.0;       ///< Way of the direction of the tool's axis on the unit sphere,
    double tilt_bend_rad = 0.0;  ///< and its acceleration, per step².
    double moved_mm = 0.0;       ///< Way of the tip in the rotating frame.
    double chord_mm = 0.0;       ///< Of an arc in it, beyond its chord.
    /// Distance of the tip from the axis that turns; from the origin if several do.
    double tip_mm = 0.0;
    /// Sine of the angle between the tool's axis and the one that turns, at most; 1 if several do.
    double lean = 1.0;
    /// The same distance of the farthest place that matters, and the height above the tip below
    /// which all such places are that are no farther than kBeside from the tool as it is at that
    /// time, whatever it does in this motion.
    double place_mm = kInf;
    double top_mm = kInf;
    static constexpr double kBeside = 1.0;  ///< mm, across the axis, from the thickest piece.
    /// How high the slabs are, at most, whose hulls the tool leaves.
    double slab_mm = kInf;

    /// Of the same tool, mounted `distance` mm higher.
    Turning raised(double distance_mm) const;
};

/// Upper bounds, in mm, at the places that matter; both without chord_mm. Valid for any angle.
double missed_mm(const Turning& turning, const ToolExtent& tool);
double gained_mm(const Pose& X_WA, const Pose& X_WB, const Turning& turning,
                 const ToolExtent& tool);

}  // namespace ncsim::toolpath
