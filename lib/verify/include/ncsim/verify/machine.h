// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is known of the machine. All of it may be missing: then the rules that need it are skipped,
// and say so.
#pragma once

#include "ncsim/cda/mesh.h"
#include "ncsim/cda/vec.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::verify {

/// Where the origins of G54 … G59.3 are assumed to be, seen from machine zero: so far below it that
/// G28 and G53 Z0 lead away from the part. mm.
inline constexpr double kHomeHeight = 300.0;

struct AxisRange {
    double min = 0.0, max = 0.0;
    bool operator==(const AxisRange&) const = default;
};

/// Something on the table that no part of a tool may touch. In W, mm.
struct Fixture {
    std::string name;
    int system = 0;  ///< The coordinate system it was told in; 0: W, wherever that is.
    /// A box; or a closed mesh, where it has triangles, and then `box` encloses it.
    cda::Box box;
    cda::TriangleMesh mesh;
    double deflection_mm = 0.0;  ///< How far the mesh may be from what its file means.
    std::string mesh_at{};       ///< Where the mesh was told: "mill.toml:12:1".
    bool as_hull = false;        ///< Its convex hull stands for the mesh among links.
    std::string assumed{};       ///< Assumptions of the run that wrote the mesh; empty: none.
    /// Every part of a tool must stay this far away, mm.
    double clearance_mm = 0.0;

    /// All it may reach, and what has to stay free around it.
    cda::Box place() const;
};

/// Lengths mm, rates mm/min, accelerations mm/s². Index 0, 1, 2: X, Y, Z.
struct MachineDescription {
    std::string name;
    std::array<std::optional<AxisRange>, 3> travel;  ///< In machine coordinates.
    /// Of A, B and C, degrees of the machine, and where W has its zeros in them.
    std::array<std::optional<AxisRange>, 3> rotary_travel;
    std::array<double, 3> rotary_zero{};
    std::array<std::optional<double>, 3> rapid;
    std::array<std::optional<double>, 3> acceleration;
    /// How far a corner may be cut, mm: what sets the speed through it. See cycle_time.h.
    double junction_deviation = 0.01;
    std::optional<double> max_feed;
    std::optional<double> min_rpm, max_rpm;
    /// Where G28 leads, and G30, the second reference point, where tools are changed; in machine
    /// coordinates. M6 itself moves nothing here.
    std::optional<cda::Vec3> home, tool_change;
    std::optional<double> tool_change_seconds;
    /// Where the zero of W lies in machine coordinates.
    std::optional<cda::Vec3> work_zero;
    std::vector<Fixture> fixtures;
    bool fixtures_told = false;  ///< Also if there is none.
    double below_stock = 0.0;    ///< What may be cut into below the stock.
    /// How far the tip may leave the straight line of a feed move that turns it, mm.
    std::optional<double> path_deviation;
};

}  // namespace ncsim::verify
