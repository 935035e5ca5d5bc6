// SPDX-License-Identifier: GPL-3.0-or-later
//
// Description of the machine for verification. Every value may be missing; rules that need a
// missing value are skipped and say so.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/base/vec3.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::verify {

/// Assumed height (mm) of machine zero above the origins of G54 … G59.3, so large that G28 and G53
/// Z0 lead away from the part.
inline constexpr double kHomeHeight = 300.0;

/// Travel of an axis.
struct AxisRange {
    double min = 0.0, max = 0.0;
    bool operator==(const AxisRange&) const = default;
};

/// Body on the table that no part of a tool may touch; mm, W.
struct Fixture {
    std::string name;
    int system = 0;  ///< Coordinate system of its specification; 0: W.
    /// Shape: `mesh` (closed) if it has triangles, enclosed by `box`; otherwise `box`.
    Box box;
    TriangleMesh mesh;
    double deflection_mm = 0.0;  ///< Largest distance of the mesh from the true surface.
    std::string mesh_at{};       ///< Place of the specification: "mill.toml:12:1".
    bool as_hull = false;        ///< The convex hull replaces the mesh in checks against links.
    std::string assumed{};       ///< Assumptions of the run that wrote the mesh; empty: none.
    /// Distance that every part of a tool must keep, mm.
    double clearance_mm = 0.0;

    /// Returns the box of the fixture, grown by the clearance and the deflection.
    Box place() const;
};

/// Returns the fixture as messages name it: "the fixture 'rear jaw'".
std::string name_of(const Fixture& fixture);

/// Limits and positions of the machine. Lengths in mm, rates in mm/min, accelerations in mm/s².
/// Index 0, 1, 2: X, Y, Z.
struct MachineDescription {
    std::string name;
    std::array<std::optional<AxisRange>, 3> travel;  ///< Machine coordinates.
    /// Travels of A, B and C in degrees of the machine, and the machine positions of the zeros of W
    /// on A, B and C.
    std::array<std::optional<AxisRange>, 3> rotary_travel;
    std::array<double, 3> rotary_zero{};
    std::array<std::optional<double>, 3> rapid;
    std::array<std::optional<double>, 3> acceleration;
    /// Largest distance (mm) by which a corner may be cut; determines the speed through the corner.
    /// See cycle_time.h.
    double junction_deviation = 0.01;
    std::optional<double> max_feed;
    std::optional<double> min_rpm, max_rpm;
    /// Position to which G28 leads, and position to which G30 leads (second reference point, tool
    /// change); machine coordinates. M6 itself moves nothing.
    std::optional<Vec3> home, tool_change;
    std::optional<double> tool_change_seconds;
    /// Position of the zero of W in machine coordinates.
    std::optional<Vec3> work_zero;
    std::vector<Fixture> fixtures;
    bool fixtures_specified = false;  ///< Also true if the specified list is empty.
    double below_stock = 0.0;         ///< Permitted depth below the stock, mm.
    /// Largest permitted distance (mm) of the tip from the straight line of a feed move that turns
    /// rotary axes.
    std::optional<double> path_deviation;
};

}  // namespace ncsim::verify
