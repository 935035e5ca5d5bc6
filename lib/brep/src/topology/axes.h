// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces in the frames of their surfaces of revolution.
#pragma once

#include "ncsim/brep/part.h"

#include <cmath>
#include <variant>

namespace ncsim::brep {

/// A point in the frame of a surface of revolution.
struct Local {
    double x, y, z, away;  // away: from the axis
};

/// Coordinates may be askew: what counts along z is then how far one has to go along a line to
/// come from the plane of x and y.
struct Axes {
    Vec3 origin, x, y, z;
    Vec3 lean;  ///< Local: what 1 mm along the line is.

    Axes(Vec3 at, const Frame& frame)
        : origin(at),
          x(frame.x),
          y(cda::cross(frame.axis, frame.x)),
          z(frame.axis),
          lean{0.0, 0.0, 1.0} {}
    /// In which an extrusion is a cylinder.
    Axes(const Extrusion& of, const Frame& frame) : Axes(of.centre, frame) {
        lean = upright(of.along);
    }

    /// By components along x, y and z as they are.
    Vec3 upright(Vec3 v) const { return {cda::dot(v, x), cda::dot(v, y), cda::dot(v, z)}; }
    Vec3 turned(Vec3 v) const {
        const Vec3 u = upright(v);
        const double far = u.z / lean.z;
        return {u.x - far * lean.x, u.y - far * lean.y, far};
    }
    Local operator()(Vec3 p) const {
        const Vec3 v = turned(p - origin);
        return {v.x, v.y, v.z, std::sqrt(v.x * v.x + v.y * v.y)};
    }
};

/// The same of a point of a dome: about the centre of its circle, and along the arc.
Local local_on(const Dome& dome, const Axes& axes, Vec3 p);

/// Of the face of a form that has an axis, from `origin`.
inline Axes axes_of(const Face& face, Vec3 origin) {
    const auto* askew = std::get_if<Extrusion>(&face.surface.form);
    return askew ? Axes(*askew, face.frame) : Axes(origin, face.frame);
}

/// Calls `visit` for each edge of a face with its track, and 1 or -1 for the way along it.
template <typename Visit>
void for_edges(const Part& part, const Face& face, const Visit& visit) {
    for (const Loop& loop : face.loops) {
        for (const EdgeUse& use : loop) {
            const Edge& edge = part.edges[use.edge];
            visit(Track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]),
                  use.is_forward ? 1.0 : -1.0);
        }
    }
}

/// Where the face of a ring is not, on the way around the tube, degrees in (-180, 180]: in the
/// middle of the widest gap between points of its edges, of those that are not between two edges
/// with the face between them.
/// Of a spindle in the tip.
double cut_of(const Part& part, const Face& face, const Axes& axes, const Torus& torus);
/// From there on, degrees.
double degrees_from(double cut, const Torus& torus, const Local& p);

}  // namespace ncsim::brep
