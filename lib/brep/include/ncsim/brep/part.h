// SPDX-License-Identifier: GPL-3.0-or-later
//
// A boundary representation: faces on surfaces, bounded by edges on curves, as CAD knows it
// (ISO 10303-42). mm, frame W.
#pragma once

#include "ncsim/brep/curve.h"
#include "ncsim/brep/surface.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/origin.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// Between two vertices, which may be one.
struct Edge {
    std::uint32_t from = 0, to = 0;  ///< Indices into Part::vertices.
    Curve curve;
};

/// An edge as a loop runs along it.
struct EdgeUse {
    std::uint32_t edge = 0;  ///< Index into Part::edges.
    bool is_forward = true;
};
using Loop = std::vector<EdgeUse>;

/// Where the parameters of a surface start: CAD unrolls cylinders from the x axis.
struct Frame {
    Vec3 origin, axis, x;
};

/// Its loops have it on their left, seen from outside of the material. Of planes the first is the
/// outline; other faces may have any number that go round.
struct Face {
    Surface surface;
    Frame frame;  ///< Of the surface; of planes only the axis counts.
    std::vector<Loop> loops;
    cda::Origin origin = cda::kStockOrigin;  ///< Who gives it its colour.
    std::vector<cda::Origin> origins;        ///< Who cut it, ascending.
    /// A facet of a round tool that was not recognised as anything better.
    bool is_facet = false;
};

/// A closed surface: indices into Part::faces.
using Shell = std::vector<std::uint32_t>;

struct Solid {
    Shell outside;
    std::vector<Shell> voids;
};

/// Each edge is used twice, in opposite directions.
struct Part {
    std::vector<Vec3> vertices;
    std::vector<Edge> edges;
    std::vector<Face> faces;
    std::vector<Solid> solids;
    /// Largest distance of an edge from a surface it lies on, as measured: of faces that have no
    /// facet beside them, and of the others.
    double miss_mm = 0.0, facet_miss_mm = 0.0;
};

/// The boundary with all its faces flat and all its edges straight. `origins` are those of each
/// face.
Part faceted(const cda::Boundary& boundary, const std::vector<std::vector<cda::Origin>>& origins);

}  // namespace ncsim::brep
