// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part with planar faces from a boundary.
#include "ncsim/brep/part.h"

#include "geometry/no_index.h"
#include "topology/nesting.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::brep {

std::size_t mark_tessellated(Part& part, cda::Origin origin) {
    const auto is_candidate = [&](const Face& face) {
        return std::holds_alternative<Plane>(face.surface.form) &&
               face.origins == std::vector{origin};
    };
    std::vector<std::uint32_t> face_of_edge(part.edges.size(), kNone);
    std::set<std::uint32_t> found;
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        if (!is_candidate(part.faces[f])) continue;
        const Vec3 normal = std::get<Plane>(part.faces[f].surface.form).normal;
        for (const Loop& loop : part.faces[f].loops) {
            for (const EdgeUse& use : loop) {
                const std::uint32_t other = std::exchange(face_of_edge[use.edge], f);
                if (other == kNone || other == f) continue;
                // Adjacent facets of a curved surface meet at an angle of less than 30°.
                if (dot(normal, std::get<Plane>(part.faces[other].surface.form).normal) < 0.866)
                    continue;
                found.insert({f, other});
            }
        }
    }
    for (const std::uint32_t f : found)
        part.faces[f].is_facet = true;
    return found.size();
}

Part faceted(const cda::Boundary& boundary, const std::vector<std::vector<cda::Origin>>& origins) {
    Part part;
    part.vertices = boundary.vertices;
    std::unordered_map<std::uint64_t, std::uint32_t> edges;  // By both vertices.
    const auto edge = [&](std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax(a, b);
        const auto [at, is_new] = edges.try_emplace(std::uint64_t{low} << 32 | high,
                                                    static_cast<std::uint32_t>(part.edges.size()));
        if (is_new) part.edges.push_back({low, high, Line{}});
        return at->second;
    };
    const auto shells = shells_of(boundary);
    const auto shell = [&](std::uint32_t s) {
        Shell made;
        for (const std::uint32_t f : shells[s]) {
            const cda::BoundaryFace& from = boundary.faces[f];
            Face face;
            const Vec3 a = boundary.vertices[from.loops[0][0]];
            const Vec3 b = boundary.vertices[from.loops[0][1]];
            face.surface.form = Plane{a, from.normal};
            face.frame = {a, from.normal,
                          normalized(from.loops[0][0] < from.loops[0][1] ? b - a : a - b)};
            for (const auto& corners : from.loops) {
                Loop& loop = face.loops.emplace_back();
                for (std::size_t i = 0; i < corners.size(); ++i) {
                    const std::uint32_t p = corners[i], q = corners[(i + 1) % corners.size()];
                    loop.push_back({edge(p, q), p < q});
                }
            }
            face.origin = from.origin;
            face.origins = origins[f];
            made.push_back(static_cast<std::uint32_t>(part.faces.size()));
            part.faces.push_back(std::move(face));
        }
        return made;
    };
    for (const Nesting& nesting : nesting_of(boundary)) {
        Solid solid{shell(nesting.outside), {}};
        for (const std::uint32_t s : nesting.voids)
            solid.voids.push_back(shell(s));
        part.solids.push_back(std::move(solid));
    }
    return part;
}

}  // namespace ncsim::brep
