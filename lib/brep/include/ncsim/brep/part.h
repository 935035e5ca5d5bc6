// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boundary representation: faces on surfaces, bounded by edges on curves, with the entities of ISO
// 10303-42. mm, frame W.
#pragma once

#include "ncsim/brep/curve.h"
#include "ncsim/brep/surface_forms.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/origin.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// Curve between two vertices, which may be equal.
struct Edge {
    std::uint32_t from = 0, to = 0;  ///< Indices into Part::vertices.
    Curve curve;
};

/// Edge with the direction in which a loop uses the edge.
struct EdgeUse {
    std::uint32_t edge = 0;  ///< Index into Part::edges.
    bool is_forward = true;
};
using Loop = std::vector<EdgeUse>;

/// Frame from which the parameters of a surface start: CAD systems unroll cylinders from the x
/// axis.
struct Frame {
    Vec3 origin, axis, x;
};

/// Bounded part of a surface. The face lies on the left of its loops, seen from outside the
/// material. On planes the first loop is the outline; other forms may have any number of loops that
/// go round.
struct Face {
    Surface surface;
    Frame frame;  ///< Frame of the surface; planes use the axis only.
    std::vector<Loop> loops;
    cda::Origin origin = cda::kStockOrigin;  ///< Motion that determines the colour.
    std::vector<cda::Origin> origins;        ///< Motions that cut the face, ascending.
    /// True for a facet of a round tool that matched no surface.
    bool is_facet = false;
};

/// Closed surface: indices into Part::faces.
using Shell = std::vector<std::uint32_t>;

/// Solid with the shells of its voids.
struct Solid {
    Shell outside;
    std::vector<Shell> voids;
};

/// Boundary representation of one or more solids. Each edge is used twice, in opposite directions.
struct Part {
    std::vector<Vec3> vertices;
    std::vector<Edge> edges;
    std::vector<Face> faces;
    std::vector<Solid> solids;
    /// Largest measured distance of an edge from a surface on which the edge lies, mm: over faces
    /// without adjacent facets, and over all remaining faces.
    double miss_mm = 0.0, facet_miss_mm = 0.0;
};

/// Marks planar faces of `origin` as facets if they meet another such face at an angle of less than
/// 30°, as facets of a mesh do that stand for a curved surface. Returns: the number of faces.
std::size_t mark_tessellated(Part& part, cda::Origin origin);

/// Returns the boundary as a part with planes and straight edges only. `origins` are the motions
/// that cut each face.
Part faceted(const cda::Boundary& boundary, const std::vector<std::vector<cda::Origin>>& origins);

}  // namespace ncsim::brep
