// SPDX-License-Identifier: GPL-3.0-or-later
//
// A body of any shape as the kernel takes it in: a convex one less others. Stock that is not
// convex, for instance: castings, or what another program has left.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/mesh.h"
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

/// Stands in mesh files before the reasons for doubt about the run that wrote them.
inline constexpr std::string_view kAssumedMark = "ncsim assumed: ";

/// outer \ (carved[0] ∪ carved[1] ∪ …)
struct Shape {
    Lattice lattice;
    Cell outer;
    std::vector<Cell> carved;
    /// Assumptions of the run that wrote the shape to a file, a line of text each.
    std::vector<std::string> assumed{};
};

/// The inside of a closed surface. Corners are rounded to the lattice and triangles that lie in a
/// plane within two units share it, quantised outwards as hulls are: the shape differs from the
/// inside by two units at most, 20 nm on the finest lattice. A convex surface becomes one cell.
/// Requires a mesh as check() finds closed, facing outwards, within the reach of the lattice.
/// Throws std::invalid_argument if it encloses no volume, crosses itself, or consists of bodies
/// that overlap.
///
/// Source: Fuchs, Kedem and Naylor, "On Visible Surface Generation by A Priori Tree Structures",
/// SIGGRAPH 1980, after halving space at medians. Expected O(n log n) for n triangles.
Shape shape_of(const TriangleMesh& mesh, const Lattice& lattice);

/// The inside of a closed surface, as shape_of() has it, in convex pieces: they fill it without gap
/// or overlap, but for two units at its surface. A convex surface is one piece. Bodies may overlap,
/// and so do their pieces then; otherwise requires and throws what shape_of() does. At most as many
/// pieces as planes of the surface cut each other; in parts with few curves far fewer than
/// triangles.
std::vector<ConvexPolytope> convex_pieces(const TriangleMesh& mesh, const Lattice& lattice);

/// The shape as a workpiece of the model's kind.
std::unique_ptr<WorkpieceModel> create(const WorkpieceModel& prototype, const Shape& shape);

/// Turns by right angles, which keep lattice points lattice points, then moves.
struct Placement {
    /// Rows: where x, y and z of the result come from. Entries are −1, 0 or 1, determinant 1.
    std::array<std::array<int, 3>, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    LatticePoint shift;

    /// First this, then a turn about an axis (0, 1, 2) through the origin, by `quarters` · 90°,
    /// counter-clockwise seen from where the axis points to.
    Placement turned(int axis, int quarters) const;
};

/// Exact. Throws std::invalid_argument if the result leaves the range of the lattice.
Shape placed(const Shape& shape, const Placement& placement);

/// Writes a shape as text, cell by cell as they come:
///
///     ncsim stock 2
///     assumed T1: …         an assumption of the run that left it; any number of lines
///     unit 1e-05            millimetres
///     normal 0 0 1          numbered from 0
///     outer 0 500 …         a cell: pairs of a normal's number and a distance, n·x <= d in units
///     cell 3 -250 …         what is carved out of it
///     end 12                how many cells were carved
class ShapeWriter {
public:
    /// `assumed`: texts of one line.
    ShapeWriter(std::ostream& out, const Lattice& lattice, const Cell& outer,
                const std::vector<std::string>& assumed = {});
    ~ShapeWriter();
    ShapeWriter(ShapeWriter&&) noexcept;
    void carve(const Cell& cell);
    /// Once, at last.
    void end();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Reads what ShapeWriter writes, and version 1 of the format, which did not record assumptions:
/// Shape::assumed says so.
/// Throws: std::runtime_error, "LINE: why", for numbers out of range, cells without end, a file
/// that breaks off, and all other text.
Shape read_shape(std::istream& in);

}  // namespace ncsim::cda
