// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coordinates of faces in the frames of their surfaces of revolution.
#pragma once

#include "ncsim/brep/part.h"

#include "topology/face_edges.h"

#include <cmath>
#include <variant>

namespace ncsim::brep {

/// A point in the frame of a surface of revolution.
struct Local {
    double x, y, z, radius;  // radius: distance from the axis
};

/// Coordinates about an axis, possibly oblique. Oblique z is the distance from the plane of x and y
/// along a line.
struct Axes {
    Vec3 origin, x, y, z;
    Vec3 lean;  ///< Local components of 1 mm along the line.

    Axes(Vec3 at, const Frame& frame)
        : origin(at),
          x(frame.x),
          y(cross(frame.axis, frame.x)),
          z(frame.axis),
          lean{0.0, 0.0, 1.0} {}
    /// Axes in which an extrusion is a cylinder.
    Axes(const Extrusion& of, const Frame& frame) : Axes(of.centre, frame) {
        lean = rectangular_components(of.along);
    }

    /// Returns the rectangular components along x, y and z.
    Vec3 rectangular_components(Vec3 v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
    Vec3 oblique_components(Vec3 v) const {
        const Vec3 u = rectangular_components(v);
        const double far = u.z / lean.z;
        return {u.x - far * lean.x, u.y - far * lean.y, far};
    }
    Local operator()(Vec3 p) const {
        const Vec3 v = oblique_components(p - origin);
        return {v.x, v.y, v.z, std::sqrt(v.x * v.x + v.y * v.y)};
    }
};

/// Returns the coordinates of a point of a dome: about the centre of the circle, and along the arc.
Local local_on(const Dome& dome, const Axes& axes, Vec3 p);

/// Returns the axes of a face whose form has an axis, from `origin`; extrusions start at their
/// centre.
inline Axes axes_of(const Face& face, Vec3 origin) {
    const auto* askew = std::get_if<Extrusion>(&face.surface.form);
    return askew ? Axes(*askew, face.frame) : Axes(origin, face.frame);
}

/// Calls `visit` for each edge of a face, with the track of the edge and the direction of use, 1 or
/// -1.
template <typename Visit>
void for_edges(const Part& part, const Face& face, const Visit& visit) {
    for (const EdgeUse& use : uses_of(face)) {
        const Edge& edge = part.edges[use.edge];
        visit(track_of(part, edge), use.is_forward ? 1.0 : -1.0);
    }
}

/// Returns an angle around the tube at which the face of a torus is absent, degrees in (-180, 180]:
/// the middle of the widest gap between points of the edges, without gaps that the face fills. For
/// a spindle, returns the angle of the tip.
double cut_of(const Part& part, const Face& face, const Axes& axes, const Torus& torus);
/// Returns the angle of `p` around the tube from `cut`, degrees.
double degrees_from(double cut, const Torus& torus, const Local& p);

}  // namespace ncsim::brep
