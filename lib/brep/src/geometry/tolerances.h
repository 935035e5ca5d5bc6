// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tolerances of boundary representations. All other tolerances of this library are multiples of
// these tolerances, with the reason given where the multiple is used.
#pragma once

#include "ncsim/base/vec3.h"

#include <cmath>

namespace ncsim::brep {

// Rounding of doubles --------------------------------------------------------------------------

/// Rounding of results about 1: cosines, parameters of curves, angles in radians or degrees.
/// Effect: smaller steps end iterations; smaller products count as 0.
inline constexpr double kUnitRounding = 1e-12;
/// Rounding of results with coordinates of up to a metre, mm; of 1 for directions and shares.
/// Effect: lengths, sines and differences up to this value count as 0.
inline constexpr double kRounding = 1e-9;
/// Error of points that iterations place on surfaces, mm; of 1 for directions, degrees for places
/// on arcs. STEP files state the same uncertainty.
/// Effect: points that differ less are equal; surfaces within this distance contain a point.
inline constexpr double kPointError = 1e-6;

// CAD readers ----------------------------------------------------------------------------------

/// Distance up to which CAD readers take two points for a single point, mm. OpenCASCADE gives
/// vertices and edges this tolerance (`Precision::Confusion`).
/// Effect: corners that are nearer become one corner; twice the value is the limit for curves.
inline constexpr double kReaderMm = 1e-7;

// Numbers in programs --------------------------------------------------------------------------

/// Least size of a detail that programs mean, mm. Programs round coordinates to 1 µm.
/// Effect: narrower faces and smaller circles are not kept; angles closer to an axis are
/// undetermined.
inline constexpr double kLeastSizeMm = 1e-3;
/// Largest gap at which surfaces count as tangent, mm. Both ends and the centre of an arc are
/// rounded, so lines and arcs that are meant to be tangent miss each other by up to three times the
/// rounding.
/// Effect: corners and edges within this distance of all their surfaces are sound.
inline constexpr double kTangencyGapMm = 3e-3;
/// Least distance of distinct axes, mm; three times the gap of tangent surfaces.
/// Effect: closer axes count as equal, or the case stays undecided.
inline constexpr double kLeastAxisDistance = 0.01;
/// Angle of directions that programs mean to be parallel, rad: 1 µm over the size of a part.
/// Effect: surfaces at a smaller angle are parallel and have no crossing.
inline constexpr double kParallelAngle = 1e-5;
/// Sine of the angle below which two surfaces or directions do not determine where they cross.
/// Effect: crossings at smaller angles are taken along the common tangent.
inline constexpr double kLeastSine = 1e-3;
/// Length over which directions of a part count, mm.
/// Effect: converts a difference of directions to a distance.
inline constexpr double kPartMm = 100.0;

// Polyhedra ------------------------------------------------------------------------------------

/// Distance within which planes of a simplified boundary meet, mm.
/// Effect: corners of facets that are off a plane by more make the plane a facet that is divided.
inline constexpr double kFlat = 1e-4;
/// Largest distance of edges of facets from the adjacent faces, in errors of the facets. Corners
/// where hulls meet lie farther out than corners of the tool's polygon.
/// Effect: larger misses make the adjacent face a facet.
inline constexpr double kFacetSlack = 1.6;

// Limits of work -------------------------------------------------------------------------------

/// Largest number of steps of an iteration, and of halvings of an interval: 60 halvings of any
/// interval reach the rounding of doubles.
inline constexpr int kMostSteps = 60;
/// Number of places at which a curve or surface is sampled if there is no formula.
inline constexpr int kSamples = 32;

inline bool is_parallel(Vec3 a, Vec3 b) {
    return norm(cross(a, b)) <= kParallelAngle;
}
inline bool is_perpendicular(Vec3 a, Vec3 b) {
    return std::abs(dot(a, b)) <= kParallelAngle;
}
/// True if two lengths are equal except for rounding in programs.
inline bool is_near(double a, double b) {
    return std::abs(a - b) <= kTangencyGapMm;
}
/// Returns the vector from the axis to `p`, perpendicular to the axis.
inline Vec3 radial_vector(Vec3 origin, Vec3 axis, Vec3 p) {
    const Vec3 v = p - origin;
    return v - dot(v, axis) * axis;
}

}  // namespace ncsim::brep
