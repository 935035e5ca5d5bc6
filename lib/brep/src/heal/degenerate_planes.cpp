// SPDX-License-Identifier: GPL-3.0-or-later
#include "heal/degenerate_planes.h"

#include "geometry/tolerances.h"
#include "heal/non_simple_faces.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace ncsim::brep {

namespace {

// Returns the planar faces whose edges are all so short that CAD readers lose every edge. The face
// is then connected to no other face.
std::vector<std::uint32_t> planes_of_no_size(const Part& part) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        const Face& face = part.faces[f];
        const bool are_short = std::ranges::all_of(uses_of(face), [&](const EdgeUse& use) {
            const Edge& edge = part.edges[use.edge];
            return is_straight(edge) && length_of_chord(part, edge) < 30.0 * kPointError;
        });
        if (are_short && is_plane(face)) found.push_back(f);
    }
    return found;
}

// True if the region inside a loop of straight edges is narrower than `corners` times the largest
// width of a corner of the loop. The width of the region is its area over half its perimeter.
bool has_no_width(const Part& part, const Plane& plane, const Loop& loop,
                  const std::vector<double>& width_of, double corners) {
    double perimeter = 0.0, twice_area = 0.0, widest = 0.0;
    for (const EdgeUse& use : loop) {
        const Edge& edge = part.edges[use.edge];
        if (!std::holds_alternative<Line>(edge.curve)) return false;
        const Vec3 a = part.vertices[edge.from] - plane.origin;
        const Vec3 b = part.vertices[edge.to] - plane.origin;
        const double turn = dot(plane.normal, cross(a, b));
        twice_area += use.is_forward ? turn : -turn;
        perimeter += norm(b - a);
        widest = std::max({widest, width_of[edge.from], width_of[edge.to]});
    }
    return std::abs(twice_area) < corners * widest * perimeter;
}

// Returns the planar faces that CAD readers lose because the width of a corner exceeds the width of
// the face or of a hole.
std::vector<std::uint32_t> planes_of_no_width(const Part& part) {
    const std::vector<double> width_of = reader_widths(part).corners;
    std::vector<std::uint32_t> found;
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        const auto* plane = std::get_if<Plane>(&part.faces[f].surface.form);
        if (!plane) continue;
        // CAD readers may miss a hole that is narrower than two widths of a corner.
        const std::vector<Loop>& loops = part.faces[f].loops;
        const auto is_narrow = [&](const Loop& loop) {
            return has_no_width(part, *plane, loop, width_of, &loop == &loops.front() ? 1.0 : 2.0);
        };
        if (std::ranges::any_of(loops, is_narrow)) found.push_back(f);
    }
    return found;
}

}  // namespace

std::vector<std::uint32_t> degenerate_planes(const Part& part) {
    std::vector<std::uint32_t> found = crossed_planes(part);
    for (const auto& more : {planes_of_no_size(part), planes_of_no_width(part)})
        found.insert(found.end(), more.begin(), more.end());
    sort_unique(found);
    return found;
}

}  // namespace ncsim::brep
