// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a saw would show: a part cut by a plane at right angles to an axis of the program. mm.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ncsim::brep {

/// Where `axis` (0 X, 1 Y, 2 Z) is `at`.
struct SectionPlane {
    int axis = 2;
    double at = 0.0;
    bool operator==(const SectionPlane&) const = default;
};

/// "z=-4", "X=1.5"; nothing of anything else.
std::optional<SectionPlane> parse_section_plane(std::string_view text);
/// "z=-4"
std::string name_of(const SectionPlane& plane);

/// On the drawing, which shows the plane Z = c from above with X to the right and Y up, Y = c from
/// the front with X to the right and Z up, X = c from the right with Y to the right and Z up.
struct FlatPoint {
    double u = 0.0, v = 0.0;
    bool operator==(const FlatPoint&) const = default;
};

struct FlatLine {};
struct FlatArc {
    FlatPoint centre;
    double radius = 0.0;
    bool is_ccw = true;
};
struct FlatEllipse {
    FlatPoint centre, major;  ///< `major`: from the centre to where it is widest.
    double minor_radius = 0.0;
    bool is_ccw = true;
};
/// Of a curve that is none of these: points on it between the ends, so near to each other that
/// the chords are within kChordsMm of it.
struct FlatChords {
    std::vector<FlatPoint> between;
};
inline constexpr double kChordsMm = 1e-3;

/// A circle or an ellipse as a whole ends where it starts.
struct SectionPiece {
    FlatPoint from, to;
    std::variant<FlatLine, FlatArc, FlatEllipse, FlatChords> curve;
    cda::Origin origin = cda::kStockOrigin;  ///< Who cut the face that it is of.
    bool is_facet = false;                   ///< Of a facet that was not recognised.
};

/// Each piece starts where the last one ends, and the first one where the last one does. Material
/// is on the left: outlines go counter-clockwise, holes clockwise.
using Outline = std::vector<SectionPiece>;

struct Section {
    SectionPlane plane;
    std::vector<Outline> outlines;
    double area_mm2 = 0.0;
    double length_mm = 0.0;  ///< Of all outlines.
    /// So much more or less area there may be for each mm that its surfaces are off: the lengths
    /// of the pieces, more where surfaces meet the plane at a small angle.
    double area_per_mm = 0.0;
};

/// A plane in which a face lies shows what is just on the side from which the drawing is seen: of
/// Z = -4, where a pocket is 4 deep, its walls. What is nearer than 1 µm lies in the plane.
///
/// Nothing where the curves of the faces do not make closed outlines, and for rings that the plane
/// cuts askew; never a part of a section. O(n + k log k) for n edges, k of which meet the plane.
std::optional<Section> section_of(const Part& part, const SectionPlane& plane);

}  // namespace ncsim::brep
