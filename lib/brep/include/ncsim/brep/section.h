// SPDX-License-Identifier: GPL-3.0-or-later
//
// Section of a part by a plane perpendicular to an axis of the program. mm. Points are those of a
// drawing, which shows the plane Z = c from above (x is X, y is Y), Y = c from the front (x is X, y
// is Z), X = c from the right (x is Y, y is Z).
#pragma once

#include "ncsim/base/vec2.h"
#include "ncsim/brep/part.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ncsim::brep {

/// Plane on which the coordinate `axis` (0 X, 1 Y, 2 Z) has the value `at`.
struct SectionPlane {
    int axis = 2;
    double at = 0.0;
    bool operator==(const SectionPlane&) const = default;
};

/// Parses a text such as "z=-4" or "X=1.5"; returns no value for any other text.
std::optional<SectionPlane> parse_section_plane(std::string_view text);
/// Returns the plane as text, such as "z=-4".
std::string name_of(const SectionPlane& plane);

/// Straight piece.
struct FlatLine {};
/// Circular arc.
struct FlatArc {
    Vec2 centre;
    double radius = 0.0;
    bool is_ccw = true;
};
/// Elliptical arc.
struct FlatEllipse {
    Vec2 centre, major;  ///< `major`: from the centre to the farthest point.
    double minor_radius = 0.0;
    bool is_ccw = true;
};
/// Polyline for curves of any other kind: intermediate points, so dense that the chords are within
/// kChordsMm of the curve.
struct FlatChords {
    std::vector<Vec2> between;
};
/// Largest distance between chords and curve, mm.
inline constexpr double kChordsMm = 1e-3;

/// Piece of an outline. A whole circle or ellipse ends where it starts.
struct SectionPiece {
    Vec2 from, to;
    std::variant<FlatLine, FlatArc, FlatEllipse, FlatChords> curve;
    cda::Origin origin = cda::kStockOrigin;  ///< Motion that cut the face.
    bool is_facet = false;                   ///< True if the face is an unrecognised facet.
};

/// Closed outline: each piece starts at the end of the previous piece. Material is on the left, so
/// outer outlines run counter-clockwise, holes clockwise.
using Outline = std::vector<SectionPiece>;

/// Section of a part by a plane.
struct Section {
    SectionPlane plane;
    std::vector<Outline> outlines;
    double area_mm2 = 0.0;
    double length_mm = 0.0;  ///< Total length of all outlines.
    /// Bound of the area error per mm of surface error: the length of the pieces, increased where a
    /// surface meets the plane at a small angle.
    double area_per_mm = 0.0;
};

/// Returns the section of `part` by `plane`. Points within 1 µm of the plane count as in the plane.
/// If a face lies in the plane, the section shows the material just on the viewer's side: Z = -4
/// through a pocket 4 deep shows the walls.
/// Returns: the section, or no value if the curves of the faces do not make closed outlines, or if
/// the plane cuts a torus obliquely; never a partial section.
/// Cost: O(n + k log k) for n edges, k of which meet the plane.
std::optional<Section> section_of(const Part& part, const SectionPlane& plane);

}  // namespace ncsim::brep
