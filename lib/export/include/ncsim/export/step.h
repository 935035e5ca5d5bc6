// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as a STEP solid, for CAD.
// Source: ISO 10303-21:2016 (text form), ISO 10303-242 (managed model based 3D engineering) or ISO
//     10303-214 (automotive design), ISO 10303-42 (geometry and topology).
#pragma once

#include "ncsim/brep/flat_part.h"
#include "ncsim/brep/measure.h"
#include "ncsim/brep/part.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/mesh/provenance.h"
#include "ncsim/mesh/simplify.h"

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>

namespace ncsim::exporter {

/// Default limit for the number of faces. Most CAD programs take minutes to open a larger file.
inline constexpr std::size_t kStepMaxFaces = 100'000;

/// Default tolerance in mm, above the lattice, which splits a flat wall into several facets, and
/// far above the 1e-7 mm within which readers identify two points.
inline constexpr double kStepTolerance = mesh::kFlatTolerance;

/// Application protocol. The files differ only in the entities that name the protocol and in the
/// links of attributes.
enum class StepSchema : std::uint8_t { Ap242, Ap214 };

/// Options of write_step() and write_step_solid().
struct StepOptions {
    double tolerance_mm = kStepTolerance;  ///< For simplify(); 0: exactly coplanar faces only.
    std::size_t max_faces = kStepMaxFaces;
    StepSchema schema = StepSchema::Ap242;
    std::optional<brep::Mass> mass{};  ///< Mass of the part, if already known.
    /// Writes nc_lines, tools and kind of each face as attributes.
    bool has_attributes = false;
};

/// Message for a solid that is not sound.
inline constexpr const char* kUnsoundSolid =
    "the solid has facets that cross or touch however coarse they are, and readers would find it "
    "invalid (--simplify, --tool-tolerance)";

/// Returns the part with flat faces, simplified within `tolerance_mm`, with close vertices
/// separated, and checked as readers check. If the check finds a fault, simplifies with 4, 16 and
/// 64 times the tolerance instead, where the tolerance counts as at least kStepTolerance.
brep::FlatPart flat_solid(const cda::Boundary& boundary, double tolerance_mm);

/// Writes `boundary` as STEP, in mm, with a solid for each connected part and its voids. Several
/// solids are the products SOLID_1 … of an assembly. The solid is
/// flat_solid(boundary, options.tolerance_mm): faces are flat with any number of holes, coplanar
/// adjacent faces are joined whatever tool cut them, and no edge has a vertex in the middle.
/// Points, edges and directions are shared. The name of a face lists the lines that cut the face
/// (LINE_10, LINE_10_20; STOCK); the colour is that of the tool of the first line.
///
/// With a tolerance of 0, no point moves. Planes that nearly meet in a point then give edges of
/// 1e-11 mm. Readers take the ends of such an edge for a single point and may find the shell open.
///
/// Guarantees: no point moves by more than the tolerance. An empty part gives a valid file without
///     a solid. Equal input gives equal bytes; the time in the header is that of 1970.
/// Throws: std::runtime_error if there are more than `options.max_faces` faces, if the solid is not
///     sound (flat_solid()), or if the stream fails.
void write_step(std::ostream& out, const cda::Boundary& boundary,
                const mesh::Provenance& provenance, const StepOptions& options = {});

/// Writes `part`, whose faces and edges may be curved: PLANE, CYLINDRICAL_, CONICAL_, SPHERICAL_
/// and TOROIDAL_SURFACE, SURFACE_OF_LINEAR_EXTRUSION, SURFACE_OF_REVOLUTION,
/// B_SPLINE_SURFACE_WITH_KNOTS; LINE, CIRCLE, ELLIPSE and B_SPLINE_CURVE_WITH_KNOTS. The
/// uncertainty in the file is the larger of part.miss_mm and 1e-6 mm.
///
/// Volume, area and centroid of the part, and of each solid if there are several, are validation
/// properties, with which a reader can check its result. Attributes are User Defined Attributes on
/// shape aspects of the faces.
/// Throws: std::runtime_error if there are more than `options.max_faces` faces, or if the stream
///     fails.
/// Source: CAx-IF Recommended Practices for Geometric and Assembly Validation Properties; CAx-IF
///     Recommended Practices for User Defined Attributes.
void write_step_solid(std::ostream& out, const brep::Part& part, const mesh::Provenance& provenance,
                      const StepOptions& options = {});

}  // namespace ncsim::exporter
