// SPDX-License-Identifier: GPL-3.0-or-later
//
// Normals of face corners for shaded meshes.
#include "formats/corner_normals.h"

#include "render/crease.h"

#include <algorithm>
#include <numeric>

namespace ncsim::exporter {

CornerNormals::CornerNormals(const cda::Boundary& boundary, const mesh::Provenance& provenance,
                             const Palette& palette, const brep::Shading& shading)
    : boundary_(boundary), shading_(shading), first_(boundary.vertices.size() + 1, 0) {
    for (const cda::BoundaryFace& face : boundary.faces) {
        maker_.push_back(palette.rank(provenance.of(face.origin)));
        weighted_.push_back(area_vector(face));
        for (const auto& loop : face.loops) {
            for (const std::uint32_t vertex : loop)
                ++first_[vertex + 1];
        }
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    faces_.resize(first_.back());
    std::vector<std::uint32_t> next(first_);
    for (std::uint32_t f = 0; f < boundary.faces.size(); ++f) {
        for (const auto& loop : boundary.faces[f].loops) {
            for (const std::uint32_t vertex : loop)
                faces_[next[vertex]++] = f;
        }
    }
}

Vec3 CornerNormals::at(std::uint32_t face, std::uint32_t vertex, Vec3 point) const {
    const Vec3 own = boundary_.faces[face].normal;
    using Recognition = brep::Shading::Recognition;
    const Recognition recognition = shading_.recognition(face);
    if (recognition == Recognition::Curved) return shading_.normal(face, own, vertex, point);
    // Vertices inside a face, made by triangulate(), belong to no other face.
    if (maker_[face] == 0 || vertex + 1 >= first_.size()) return own;
    Vec3 sum;
    for (std::uint32_t i = first_[vertex]; i < first_[vertex + 1]; ++i) {
        const std::uint32_t other = faces_[i];
        // The normal of a flat face ignores adjacent round faces.
        if (recognition == Recognition::Planar &&
            shading_.recognition(other) == Recognition::Curved)
            continue;
        const bool is_smooth = maker_[other] == maker_[face] &&
                               dot(own, boundary_.faces[other].normal) > kCreaseCosine;
        if (is_smooth) sum = sum + weighted_[other];
    }
    const double length = norm(sum);
    // The sum is 0 if all faces are slivers without area.
    return length > 0.0 ? (1.0 / length) * sum : own;
}

// Returns the normal of `face` times twice its area.
Vec3 CornerNormals::area_vector(const cda::BoundaryFace& face) const {
    double twofold = 0.0;
    for (const auto& loop : face.loops) {
        const Vec3 a = boundary_.vertices[loop[0]];
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            twofold += dot(face.normal, cross(boundary_.vertices[loop[i]] - a,
                                              boundary_.vertices[loop[i + 1]] - a));
        }
    }
    return std::max(twofold, 0.0) * face.normal;
}

}  // namespace ncsim::exporter
