// SPDX-License-Identifier: GPL-3.0-or-later
//
// A body of any shape as input of the kernel: a convex cell minus cells. Used for stock that is not
// convex, such as castings or the result of a previous program.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/polytope.h"

#include <array>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::cda {

class WorkpieceModel;

/// Prefix of lines in mesh files that list assumptions of the run that wrote the file.
inline constexpr std::string_view kAssumedMark = "ncsim assumed: ";

/// Record of what left the cells of one origin. The kernel keeps the texts and does not read them.
struct ShapeSource {
    std::string text;                   ///< One line.
    std::vector<std::string> surfaces;  ///< Surfaces that the source left, a line each.
    std::size_t line = 0;               ///< Line of `text` in the file, from 1.
};

/// outer \ (carved[0] ∪ carved[1] ∪ …)
struct Shape {
    Lattice lattice;
    Cell outer;
    std::vector<Cell> carved;
    /// Sources of the cells: entry i belongs to Origin{i}. Empty: unknown; all cells then have
    /// kStockOrigin.
    std::vector<ShapeSource> sources{};
    /// Assumptions of the run that wrote the shape to a file, each a line of text.
    std::vector<std::string> assumed{};
};

/// Returns the inside of a closed surface. Corners are rounded to the lattice. Triangles that lie
/// in a plane within two units share the plane, quantised outwards as for hulls. So the shape
/// differs from the inside by at most two units, 20 nm on the finest lattice. A convex surface
/// becomes one cell.
/// Requires: a mesh that check() finds closed, oriented outwards, within the range of the lattice.
/// Throws: std::invalid_argument if the surface encloses no volume, crosses itself, or consists of
/// bodies that overlap.
/// Cost: expected O(n log n) for n triangles.
/// Source: Fuchs, Kedem and Naylor, "On Visible Surface Generation by A Priori Tree Structures",
/// SIGGRAPH 1980, after halving space at medians.
Shape shape_of(const TriangleMesh& mesh, const Lattice& lattice);

/// Divides the inside of a closed surface, as in shape_of(), into convex pieces. The pieces fill
/// the inside without gap or overlap, up to two units at the surface. A convex surface is one
/// piece. Bodies may overlap, and then pieces overlap as well. Otherwise requires and throws the
/// same as shape_of(). The number of pieces is at most the number of cells into which the planes of
/// the surface divide space; in parts with few curves, far below the number of triangles.
std::vector<ConvexPolytope> convex_pieces(const TriangleMesh& mesh, const Lattice& lattice);

/// Creates a workpiece of the prototype's model with this shape.
std::unique_ptr<WorkpieceModel> create(const WorkpieceModel& prototype, const Shape& shape);

/// A rotation by right angles, which maps lattice points to lattice points, then a translation.
struct Placement {
    /// Rows of the rotation matrix. Entries are −1, 0 or 1; the determinant is 1.
    std::array<std::array<int, 3>, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    LatticePoint shift;

    /// Returns this placement followed by a rotation about axis 0, 1 or 2 through the origin, by
    /// `quarters` · 90°, counter-clockwise seen against the axis.
    Placement turned(int axis, int quarters) const;
};

/// Returns the placed shape, exactly. Texts of the sources stay as they are. Throws:
/// std::invalid_argument if the result leaves the range of the lattice.
Shape placed(const Shape& shape, const Placement& placement);

/// Writes a shape as text. Texts of the shape must be of one line each. The file has the form:
///
///     ncsim stock 3
///     assumed T1: …         an assumption of the run that left the stock; any number of lines
///     unit 1e-05            millimetres
///     source …              a source, for origin 0, 1, …; any number of lines
///     surface …             a surface that the source left; any number of lines
///     normal 0 0 1          numbered from 0
///     outer 0 500 …         a cell: pairs of a normal's number and a distance, n·x <= d in units
///     origin 4              origin of the cells that follow; 0 at the start
///     cell 3 -250 …         a carved cell
///     end 12                number of carved cells
void write_shape(std::ostream& out, const Shape& shape);

/// Reads a file written by write_shape(), also versions 1 and 2 of the format, which did not record
/// sources. Version 1 did not record assumptions; Shape::assumed then states this.
/// Throws: std::runtime_error, "LINE: why", for numbers out of range, unbounded cells, truncated
/// files, and all other text.
Shape read_shape(std::istream& in);

}  // namespace ncsim::cda
