// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the tip of a tool goes on a motion, in W, as a line, an arc or turns: what surfaces_of
// sweeps its profile along.
#pragma once

#include "ncsim/brep/surface.h"
#include "ncsim/brep/sweep.h"
#include "ncsim/cda/vec.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/machine.h"

#include <array>
#include <optional>
#include <vector>

namespace ncsim::brep {

/// An arc, its centre where it starts. mm, frame W.
struct ArcWay {
    Vec3 centre, about;
    double radius = 0.0;
    bool is_level = true;
    Vec3 fitted;  ///< The centre so that both ends are as far from it.
    double fitted_radius = 0.0;
    Vec3 ahead;           ///< Unit, from the centre to the start.
    double rise = 0.0;    ///< mm for each radian, counter-clockwise.
    double swept = 0.0;   ///< Radians, counter-clockwise.
    double start = 0.0;   ///< Radius of the start.
    double growth = 0.0;  ///< mm for each radian; 0 where programs round.
    /// Where the ends are not as far from the centre, instead of a circle; and half of what it
    /// leaves of a turn, radians.
    std::optional<Spiral> spiral;
    double left = 0.0;
};

/// A level piece of a spline: a line, or an arc. mm, frame W.
struct SplineWay {
    Vec3 from, to;
    std::optional<ArcWay> arc;
    cda::Box box;               ///< Of the way of the tip.
    std::array<Plane, 2> ends;  ///< Across the way, looking along it.
    bool begins_in_corner = true;
};

/// Splines are taken as arcs that are no farther from them, mm: what programs round.
inline constexpr double kBesideSpline = 2e-3;

/// No rotary axis moves.
bool is_still(const gcode::Position& from, const gcode::Position& to);
/// Nothing where a rotary axis moves, U, V or W do not stand at 0, the linear axes are not at right
/// angles as the rotary ones stand, or the radius changes by more than a fifth for each radian, or
/// by more than what programs round in more than a turn.
std::optional<ArcWay> way_of(const gcode::Arc& arc, const toolpath::Poses& poses);
/// None in the same cases.
std::vector<SplineWay> ways_of(const gcode::Spline& spline, const toolpath::Poses& poses);
/// Of a line on which axes turn: all of them in step, as the tool is moved.
std::optional<TurningWay> turning_way_of(const gcode::Motion& motion, const toolpath::Poses& poses);

}  // namespace ncsim::brep
