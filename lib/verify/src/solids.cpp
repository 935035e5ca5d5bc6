// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the connected pieces of a part.
#include "ncsim/verify/solids.h"

#include "ncsim/cda/triangulate.h"

#include <algorithm>
#include <utility>

namespace ncsim::verify {

Solids::Solids(const cda::Boundary& boundary)
    : mesh_(std::make_unique<const TriangleMesh>(cda::triangulate(boundary))),
      triangles_(boundary.shells) {
    std::vector<Solid> shells(boundary.shells);
    for (std::uint32_t t = 0; t < mesh_->triangles.size(); ++t) {
        const cda::BoundaryFace& face = boundary.faces[mesh_->face[t]];
        triangles_[face.shell].push_back(t);
        Solid& solid = shells[face.shell];
        const TriangleCorners c = corners_of(*mesh_, t);
        solid.volume_mm3 += dot(c[0], cross(c[1], c[2])) / 6.0;
        for (const Vec3& corner : c)
            solid.box.add(corner);
    }
    for (const cda::BoundaryFace& face : boundary.faces) {
        if (face.origin != cda::kStockOrigin) shells[face.shell].origins.push_back(face.origin);
    }
    for (std::uint32_t s = 0; s < shells.size(); ++s) {
        // A cavity is a surface with inward orientation and negative volume.
        if (shells[s].volume_mm3 <= 0.0) continue;
        auto& origins = shells[s].origins;
        std::ranges::sort(origins);
        origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
        shells[s].shell = s;
        solids_.push_back(std::move(shells[s]));
    }
    std::ranges::stable_sort(solids_, std::ranges::greater{}, &Solid::volume_mm3);
    for (const auto& triangles : triangles_)
        surfaces_.emplace_back(*mesh_, triangles);
    for (std::size_t i = 0; i < solids_.size(); ++i)
        solids_[i].inner_point = point_in(i);
}

std::optional<std::size_t> Solids::at(Vec3 point) const {
    // The smallest piece around the point: a loose piece in a closed cavity is a separate piece.
    for (std::size_t i = solids_.size(); i-- > 0;) {
        if (solids_[i].box.contains(point) && surfaces_[solids_[i].shell].contains(point)) return i;
    }
    return std::nullopt;
}

// Searches below the middle of large triangles, with decreasing depth, for a point inside.
std::optional<Vec3> Solids::point_in(std::size_t solid) const {
    const Solid& s = solids_[solid];
    std::vector<std::pair<double, std::uint32_t>> large;
    for (const std::uint32_t t : triangles_[s.shell]) {
        const TriangleCorners c = corners_of(*mesh_, t);
        large.emplace_back(-norm(cross(c[1] - c[0], c[2] - c[0])), t);
    }
    std::ranges::sort(large);
    if (large.size() > 8) large.resize(8);
    for (const auto& [area, t] : large) {
        const TriangleCorners c = corners_of(*mesh_, t);
        const Vec3 middle = (1.0 / 3) * (c[0] + c[1] + c[2]);
        const Vec3 inward = -normalized(cross(c[1] - c[0], c[2] - c[0]));
        double depth = 0.3 * norm(s.box.size());
        while (depth > 1e-6) {
            const Vec3 p = middle + depth * inward;
            if (surfaces_[s.shell].contains(p) && at(p) == solid) return p;
            depth *= 0.5;
        }
    }
    return std::nullopt;
}

}  // namespace ncsim::verify
