// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a calliper would find on a part: for people as text, for programs as JSON.
#pragma once

#include "ncsim/cda/vec.h"

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::report {

/// Who cut it, ascending; none: it is the stock's own.
struct CutBy {
    std::vector<std::uint32_t> lines, tools;
};

struct MeasuredBore {
    cda::Vec3 mouth, axis;
    double diameter = 0.0, depth = 0.0, mouth_slants_by = 0.0, covers_degrees = 360.0;
    std::string end;  ///< "through", "flat" …
    std::optional<double> tip_depth{}, tip_angle_degrees{};
    CutBy by{};
};
struct MeasuredBoss {
    cda::Vec3 foot, axis;
    double diameter = 0.0, height = 0.0, covers_degrees = 360.0;
    CutBy by{};
};
struct MeasuredCorner {
    double radius = 0.0;
    bool is_inside = true;
    double covers_degrees = 0.0;
    cda::Vec3 on_axis, axis;
    CutBy by{};
};
struct MeasuredFloor {
    double z = 0.0, area = 0.0;
    bool is_closed = false;
    cda::Box box;
    CutBy by{};
};
struct MeasuredDistance {
    double mm = 0.0;
    bool is_void = true;
    cda::Vec3 from, to;
    CutBy by{};
};

/// Lengths in mm, frame W.
struct MeasureSheet {
    std::string program;
    cda::Box extents;
    double volume_mm3 = 0.0;
    std::vector<MeasuredBore> bores;
    std::vector<MeasuredBoss> bosses;
    std::vector<MeasuredCorner> corners;
    std::vector<MeasuredFloor> floors;
    std::vector<MeasuredDistance> distances;
    bool has_too_many_walls = false;
    std::size_t facets = 0;  ///< Not recognised, so not measured.
    double facet_area_mm2 = 0.0;
    std::vector<std::uint32_t> facet_lines;
};

/// Lengths to a micrometre, no more than 40 rows of a kind.
std::string text_of(const MeasureSheet& sheet);

/// All of it, UTF-8; to a millionth of a mm. Keys are only ever added.
void write_measures(std::ostream& out, const MeasureSheet& sheet);

}  // namespace ncsim::report
