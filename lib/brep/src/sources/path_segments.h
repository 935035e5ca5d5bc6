// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths of a tool's tip during a motion: lines, arcs, and paths of tools that turn. mm, frame W.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/brep/profile_sweep.h"
#include "ncsim/brep/surface_forms.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/kinematics.h"

#include <array>
#include <optional>
#include <vector>

namespace ncsim::brep {

/// Arc, helix or spiral of the tip, with the centre at the level of the start. mm, frame W.
struct ArcPath {
    Vec3 centre, about;  ///< Of an arc or helix, the centre has equal distances from both ends.
    double radius = 0.0;
    bool is_level = true;
    Vec3 ahead;           ///< Unit, from the centre to the start.
    double rise = 0.0;    ///< mm per radian, counter-clockwise.
    double swept = 0.0;   ///< Radians, counter-clockwise.
    double start = 0.0;   ///< Radius at the start; the mean radius if `growth` is 0.
    double growth = 0.0;  ///< mm per radian; 0 if only rounding in the program.
    /// Spiral instead of a circle, if the radii of the ends differ by more than rounding; and half
    /// of the angle that is missing to a full turn, radians.
    std::optional<Spiral> spiral;
    double left = 0.0;
};

/// Level piece of a spline: a line or an arc. mm, frame W.
struct SplinePath {
    Vec3 from, to;
    std::optional<ArcPath> arc;
    Box box;                    ///< Around the path of the tip.
    std::array<Plane, 2> ends;  ///< Across the path, with normals along the path.
    bool begins_in_corner = true;
};

/// Largest distance between a spline and the arcs that replace the spline, mm; about the rounding
/// of programs.
inline constexpr double kSplineArcError = 2e-3;

/// True if no rotary axis moves.
bool are_rotary_axes_fixed(const gcode::Position& from, const gcode::Position& to);
/// Returns the path of `arc`; no value if
/// - a rotary axis moves, or U, V or W is not 0,
/// - the linear axes are not perpendicular at the positions of the rotary axes,
/// - the radius changes by more than a fifth of the radius per radian, or by more than rounding in
///   more than a turn.
std::optional<ArcPath> arc_path(const gcode::Arc& arc, const toolpath::Poses& poses);
/// Returns the pieces of `spline`; empty in the same cases.
std::vector<SplinePath> spline_paths(const gcode::Spline& spline, const toolpath::Poses& poses);
/// Returns the path of a linear motion on which rotary axes turn, in equal pieces if it turns too
/// far for one polynomial. All axes move in proportion, as in the simulation. Empty for all other
/// motions, and beyond 120 turns.
std::vector<RotaryPath> rotary_paths(const gcode::Motion& motion, const toolpath::Poses& poses);
/// Returns the planes between which the surfaces of the i-th of several pieces are. The normals
/// point along the path.
std::array<Plane, 2> ends_of(const std::vector<RotaryPath>& paths, std::size_t i);

}  // namespace ncsim::brep
