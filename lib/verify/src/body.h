// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piece of a tool that is watched on its own: a shank, a holder, the core of a cutter. Both its
// polytopes, the circumscribed and the inscribed one, so that a contact can be told certain.
#pragma once

#include "ncsim/cda/workpiece.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/finding.h"

#include <optional>
#include <vector>

namespace ncsim::verify {

/// What a convex body has in common with a part.
struct Meeting {
    bool is_there = false;  ///< Else they touch at most.
    Certainty certainty = Certainty::Within;
    std::optional<cda::Vec3> point;  ///< In both.
    cda::Box box;                    ///< Encloses it.
};

/// The pose `distance` mm along the tool axis, towards the spindle.
toolpath::Pose raised(const toolpath::Pose& X_WT, double distance);
/// The halfspaces of `cell` drawn in by `distance` (mm, > 0) or moved out (< 0).
cda::Cell shrunk(const cda::Cell& cell, double distance, const cda::Lattice& lattice);
/// Is the piece a cylinder? The planes of its polytope are exact then; those of cones and rounded
/// ends have normals that are rounded to the lattice.
bool is_prism(const toolpath::ToolPiece& piece);
/// How far (mm) the cells of this step may lie off for rounding alone: corners of turned tools, and
/// the planes of tools that are no prisms. 0 for upright prisms, whose cells are exact: for them
/// touching is exactly nothing, whatever came before.
double rounding_of(const toolpath::Step& step, bool prism, const cda::Lattice& lattice);
/// What of `cell` lies in `box` (mm), to the lattice.
cda::Cell clipped(const cda::Cell& cell, const cda::Box& box, const cda::Lattice& lattice);
/// Where the cell and the part meet: boxes (mm) of about a millimetre, or larger ones if those
/// would be more than a few. Adds to `places`.
void find_places(const cda::Cell& cell, const cda::WorkpieceModel& part, const cda::Box& stock,
                 std::vector<cda::Box>& places);
/// Does the tool stand along Z, all the time?
bool is_upright(const toolpath::Step& step);
/// Towards the spindle, or not? Only then a shank can meet what its own cutter takes away later in
/// the same motion; else the cutter was there first.
bool ascends(const toolpath::Step& step);
/// The part common to both boxes; empty where there is none.
cda::Box intersection(const cda::Box& a, const cda::Box& b);

/// What the cells that a cutter leaves in this step, `raise` mm higher, are beyond its sweep, mm,
/// at places that matter.
double gained_by(const toolpath::Cutter& cutter, const toolpath::Step& step, double raise = 0.0);

class Body {
public:
    /// `below`: what cuts before it, whose corners it has if it is as thick.
    Body(const toolpath::ToolPiece& piece, const cda::Lattice& lattice,
         toolpath::ToolAccuracy accuracy, const toolpath::ToolPiece* below = nullptr);

    /// rounding_of() this body.
    double rounding(const toolpath::Step& step) const;

    /// What the sweep of the body, `raise` mm higher on the tool, meets of `part`, which lies in
    /// `stock`. Certain if the inscribed polytope does, less what the motion's sampling gained.
    Meeting meet(const toolpath::Step& step, double raise, const cda::WorkpieceModel& part,
                 const cda::Box& stock);
    /// Is that certain? Cheaper, where nobody asks what may be.
    bool meets_certainly(const toolpath::Step& step, double raise, const cda::WorkpieceModel& part,
                         const cda::Box& stock);

    /// The cells of the sweep, circumscribed or inscribed.
    std::vector<cda::Cell> cells(const toolpath::Step& step, double raise, toolpath::Side side);
    cda::Box bounds(const toolpath::Step& step, double raise) const;
    /// What of them the inscribed ones are beyond the sweep of the body, mm, at places that matter.
    double gained(const toolpath::Step& step, double raise) const;

private:
    cda::Lattice lattice_;
    bool prism_;
    toolpath::Cutter outer_, inner_;
};

/// Finer than anybody sets a stick-out, mm.
inline constexpr double kRaiseStep = 0.01;

/// The least raise in multiples of `raise_step` (mm) above `known` at which `body` meets nothing in
/// this step (found by halving, so it is the least one if contact ends once). Requires that it does
/// at `known`. At most `limit`.
double needed_raise(Body& body, const toolpath::Step& step, double known, double limit,
                    double raise_step, const cda::WorkpieceModel& part, const cda::Box& stock);

}  // namespace ncsim::verify
