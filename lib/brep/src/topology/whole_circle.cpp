// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/whole_circle.h"

#include "geometry/tolerances.h"

#include <variant>

namespace ncsim::brep {

bool WholeCircle::is_about(Vec3 origin, Vec3 along) const {
    const Vec3 v = centre - origin;
    return norm(cross(axis, along)) < kRounding && norm(v - dot(v, along) * along) < kRounding;
}

std::optional<WholeCircle> whole_circle(const Part& part, const Loop& loop) {
    if (loop.size() != 1) return std::nullopt;
    const Edge& edge = part.edges[loop.front().edge];
    const auto* circle = std::get_if<Circle>(&edge.curve);
    if (!circle || edge.from != edge.to) return std::nullopt;
    // The edge's track starts in the vertex, so height and radius are taken from the vertex.
    const Vec3 start = part.vertices[edge.from];
    const Vec3 centre = circle->centre + dot(start - circle->centre, circle->axis) * circle->axis;
    return WholeCircle{centre, loop.front().is_forward ? circle->axis : -circle->axis, start,
                       norm(start - centre)};
}

}  // namespace ncsim::brep
