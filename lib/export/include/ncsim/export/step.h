// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as a STEP solid, for CAD. ISO 10303-21:2016 (the text form), ISO 10303-242 (managed
// model based 3D engineering) or ISO 10303-214 (automotive design), ISO 10303-42 (geometry and
// topology).
#pragma once

#include "ncsim/brep/flat_part.h"
#include "ncsim/brep/measure.h"
#include "ncsim/brep/part.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/export/provenance.h"
#include "ncsim/export/simplify.h"

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>

namespace ncsim::exporter {

/// Faces of the largest part that is written without being asked for more: beyond it most CAD
/// programs take minutes to open the file.
inline constexpr std::size_t kStepMaxFaces = 100'000;

/// Above the lattice that makes several facets of one flat wall, and far above the 1e-7 mm within
/// which readers take two points for one.
inline constexpr double kStepTolerance = kFlatTolerance;

/// Which dialect: the same entities but for those that name it, and the links of attributes.
enum class StepSchema : std::uint8_t { Ap242, Ap214 };

struct StepOptions {
    double tolerance_mm = kStepTolerance;  ///< For simplify(); 0: exactly coplanar faces only.
    std::size_t max_faces = kStepMaxFaces;
    StepSchema schema = StepSchema::Ap242;
    std::optional<brep::Mass> mass{};  ///< Of the part, where somebody knows it already.
    /// Of each face nc_lines, tools, and what it is, as attributes.
    bool has_attributes = false;
};

/// What is said of a solid that is not sound.
inline constexpr const char* kUnsoundSolid =
    "the solid has facets that cross or touch however coarse they are, and readers would find it "
    "invalid (--simplify, --tool-tolerance)";

/// The part with flat faces alone, simplified within the tolerance, kept apart and checked as
/// readers would; where they would find a fault, within 4, 16 and 64 times as much, but 4e-4 mm at
/// least.
brep::FlatPart flat_solid(const cda::Boundary& boundary, double tolerance_mm);

/// Writes `boundary` as STEP, in millimetres: a solid for each connected part, with its
/// voids. What is written is flat_solid(boundary, options.tolerance_mm): faces are flat with any
/// number of holes, neighbours in one plane are one face, whoever cut them, and no edge has a
/// vertex in its middle. No point is farther than the tolerance from where it was. Points, edges
/// and directions are shared. A face is named after the lines that cut it (LINE_10, LINE_10_20;
/// STOCK) and has the colour of its first one's tool.
///
/// With a tolerance of 0 nothing is moved, and where planes nearly meet in a point there are edges
/// of 1e-11 mm: readers take their ends for one point and may find the shell open.
///
/// A part of which nothing is left gives a valid file without a solid. Equal input gives equal
/// bytes: the time in the header is that of 1970. Throws std::runtime_error if there are more
/// than `options.max_faces` faces, if it is not sound (flat_solid()), or the stream fails.
void write_step(std::ostream& out, const cda::Boundary& boundary, const Provenance& provenance,
                const StepOptions& options = {});

/// The same for a part of faces and edges as they are, which may be curved: PLANE, CYLINDRICAL_,
/// CONICAL_, SPHERICAL_ and TOROIDAL_SURFACE, LINE, CIRCLE, ELLIPSE and B_SPLINE_CURVE_WITH_KNOTS.
/// The uncertainty in the file is part.miss_mm, if that is more than 1e-6 mm.
///
/// Volume, area and centroid of the part, and of each solid where there are several, are written as
/// validation properties (CAx-IF Recommended Practices for Geometric and Assembly Validation
/// Properties), so that readers can tell whether they read the same; attributes as CAx-IF User
/// Defined Attributes on shape aspects of the faces.
void write_step_solid(std::ostream& out, const brep::Part& part, const Provenance& provenance,
                      const StepOptions& options = {});

}  // namespace ncsim::exporter
