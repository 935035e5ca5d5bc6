// SPDX-License-Identifier: GPL-3.0-or-later
//
// Piece of a tool that is watched separately: a shank, a holder, the core of a cutter. It has both
// polytopes, circumscribed and inscribed, so a contact can be proven certain.
#pragma once

#include "ncsim/cda/workpiece.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/finding.h"

#include <optional>
#include <vector>

namespace ncsim::verify {

/// Intersection of a convex body with a part.
struct PartContact {
    bool is_there = false;  ///< False: at most a touch.
    Certainty certainty = Certainty::Within;
    std::optional<Vec3> point;  ///< Common point.
    Box box;                    ///< Encloses the intersection.
};

/// Returns the pose moved by `distance` mm along the tool axis, towards the spindle.
toolpath::Pose raise_pose(const toolpath::Pose& X_WT, double distance);
/// Returns `cell` with the halfspaces moved inwards by `distance` (mm, > 0) or outwards (< 0).
cda::Cell shrink_cell(const cda::Cell& cell, double distance, const cda::Lattice& lattice);
/// True if the piece is a cylinder. The planes of its polytope are then exact; normals of cones and
/// rounded ends are rounded to the lattice.
bool is_prism(const toolpath::ToolPiece& piece);
/// Returns the largest distance (mm) by which rounding displaces the cells of this step: corners of
/// rotated tools, and planes of tools that are not prisms. 0 for prisms whose axis is parallel to
/// X, Y or Z: their cells are exact, so a touch has exactly no common volume.
double rounding_of(const toolpath::Step& step, bool prism, const cda::Lattice& lattice);
/// Returns the part of `cell` in `box` (mm), rounded to the lattice.
cda::Cell clipped(const cda::Cell& cell, const Box& box, const cda::Lattice& lattice);
/// Adds boxes (mm) that contain the intersection of the cell and the part to `places`. The boxes
/// are about 1 mm long, or longer if more than a few would be needed.
void find_places(const cda::Cell& cell, const cda::VerifyingModel& part, const Box& stock,
                 std::vector<Box>& places);
/// True if the tool is not rotated during the whole step: its axis is Z.
bool is_upright(const toolpath::Step& step);
/// True if the tool keeps its direction and moves towards the spindle. Only then a shank can meet
/// material that the cutter removes later in the same motion; otherwise the cutter comes first.
bool ascends(const toolpath::Step& step);
/// Returns the intersection of both boxes; may be empty.
Box intersection(const Box& a, const Box& b);

/// Returns the largest distance (mm) by which the cells of a cutter in this step, `raise` mm
/// higher, exceed the true sweep, at places that matter.
double gain_of(const toolpath::Cutter& cutter, const toolpath::Step& step, double raise = 0.0);

class Body {
public:
    /// Creates the polytopes of `piece`. `below`: cutting piece below, whose corners are used if it
    /// has the same diameter.
    Body(const toolpath::ToolPiece& piece, const cda::Lattice& lattice,
         toolpath::ToolAccuracy accuracy, const toolpath::ToolPiece* below = nullptr);

    /// Returns rounding_of() for this body.
    double rounding(const toolpath::Step& step) const;

    /// Intersects the sweep of the body, `raise` mm higher on the tool, with `part`, which lies in
    /// `stock`. Certain if the inscribed polytope, minus the excess of sampling, meets the part.
    PartContact find_contact(const toolpath::Step& step, double raise,
                             const cda::VerifyingModel& part, const Box& stock);
    /// True if the contact is certain. Cheaper than meet().
    bool meets_certainly(const toolpath::Step& step, double raise, const cda::VerifyingModel& part,
                         const Box& stock);

    /// Returns the cells of the sweep, circumscribed or inscribed.
    std::vector<cda::Cell> cells(const toolpath::Step& step, double raise, toolpath::Side side);
    Box bounds(const toolpath::Step& step, double raise) const;
    /// Returns gain_of() of the inscribed cutter: the distance (mm) by which its cells exceed the
    /// sweep of the body, at places that matter.
    double gained(const toolpath::Step& step, double raise) const;

private:
    cda::Lattice lattice_;
    bool prism_;
    toolpath::Cutter outer_, inner_;
};

/// Step of raises, mm; finer than the setting of a stick-out.
inline constexpr double kRaiseStep = 0.01;

/// Returns the smallest raise, a multiple of `raise_step` (mm) above `known` and at most `limit`,
/// at which `body` meets no material in this step. Bisection finds the smallest raise if contact
/// ends only once.
/// Requires: `body` meets material at `known`.
double needed_raise(Body& body, const toolpath::Step& step, double known, double limit,
                    double raise_step, const cda::VerifyingModel& part, const Box& stock);

}  // namespace ncsim::verify
