// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures of a part that a calliper would give.
#pragma once

#include "ncsim/base/vec3.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::simulation {

/// Line of a program that left the stock.
struct EarlierLine {
    std::string program;
    std::uint32_t line = 0;
    auto operator<=>(const EarlierLine&) const = default;
};

/// Lines and tools that cut a feature, ascending; empty: a surface of the stock.
struct CutBy {
    std::vector<std::uint32_t> lines, tools;
    std::vector<EarlierLine> earlier;

    bool is_stock() const { return lines.empty() && earlier.empty(); }
};

/// Cylinder around air, more than half of a circle.
struct MeasuredBore {
    Vec3 mouth, axis;
    double diameter = 0.0, depth = 0.0, mouth_slants_by = 0.0, covers_degrees = 360.0;
    std::string end;  ///< "through", "flat" …
    std::optional<double> tip_depth{}, tip_angle_degrees{};
    CutBy by{};
};
/// Cone around air, more than half of a circle, that opens at its wide end.
struct MeasuredCountersink {
    Vec3 mouth, axis;
    double diameter = 0.0, depth = 0.0, angle_degrees = 0.0, covers_degrees = 360.0;
    bool has_tip = false;
    CutBy by{};
};
/// Plane or cone in the place of an edge: lengths along the adjacent faces, angle to the first.
struct MeasuredChamfer {
    double width = 0.0, height = 0.0, angle_degrees = 0.0, length = 0.0;
    Vec3 at;
    CutBy by{};
};
/// Thread by a tap or a thread mill, as the program says.
struct MeasuredThread {
    Vec3 mouth;
    double diameter = 0.0;
    std::optional<double> pitch{};  ///< Unknown: a tap without a pitch.
    double depth = 0.0;             ///< Distance from the mouth to the lowest position of the tip.
    bool is_inside = true;
    CutBy by{};
};
/// Cylinder around material, more than half of a circle.
struct MeasuredBoss {
    Vec3 foot, axis;
    double diameter = 0.0, height = 0.0, covers_degrees = 360.0;
    CutBy by{};
};
/// Part of a cylinder, at most half of a circle: a rounded corner.
struct MeasuredCorner {
    double radius = 0.0;
    bool is_inside = true;
    double covers_degrees = 0.0;
    Vec3 on_axis, axis;
    CutBy by{};
};
/// Plane face that looks up.
struct MeasuredFloor {
    double z = 0.0, area = 0.0;
    bool is_closed = false;
    Box box;
    CutBy by{};
};
/// Distance of two parallel faces with air (`is_void`) or with material between.
struct MeasuredDistance {
    double mm = 0.0;
    bool is_void = true;
    Vec3 from, to;
    CutBy by{};
};

/// All measures of a part. Lengths are in mm, in the frame W.
struct MeasureSheet {
    std::string program;
    Box extents;
    double volume_mm3 = 0.0;
    std::vector<MeasuredBore> bores;
    std::vector<MeasuredThread> threads{};
    std::vector<MeasuredCountersink> countersinks{};
    std::vector<MeasuredBoss> bosses;
    std::vector<MeasuredChamfer> chamfers{};
    std::vector<MeasuredCorner> corners;
    std::vector<MeasuredFloor> floors;
    std::vector<MeasuredDistance> distances;
    bool has_too_many_walls = false;
    /// Number of facets of round tools that were not recognised and therefore not measured.
    std::size_t facets = 0;
    double facet_area_mm2 = 0.0;
    std::vector<std::uint32_t> facet_lines;
};

}  // namespace ncsim::simulation
