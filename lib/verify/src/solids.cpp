// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/verify/solids.h"

#include <algorithm>
#include <array>

namespace ncsim::verify {

using cda::Vec3;

namespace {

using Corners = std::array<Vec3, 3>;

Corners corners_of(const cda::TriangleMesh& mesh, std::uint32_t triangle) {
    const auto& t = mesh.triangles[triangle];
    return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

// Does the ray from `p` meet the triangle? Möller and Trumbore, "Fast, Minimum Storage
// Ray/Triangle Intersection", 1997.
bool crosses(Vec3 p, Vec3 direction, const Corners& t) {
    const Vec3 e1 = t[1] - t[0];
    const Vec3 e2 = t[2] - t[0];
    const Vec3 h = cross(direction, e2);
    const double a = dot(e1, h);
    if (a == 0.0) return false;
    const Vec3 s = p - t[0];
    const double u = dot(s, h) / a;
    if (u < 0.0 || u > 1.0) return false;
    const Vec3 q = cross(s, e1);
    const double v = dot(direction, q) / a;
    return v >= 0.0 && u + v <= 1.0 && dot(e2, q) / a > 0.0;
}

}  // namespace

Solids::Solids(const cda::Boundary& boundary)
    : mesh_(cda::triangulate(boundary)), triangles_(boundary.shells) {
    std::vector<Solid> shells(boundary.shells);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        const cda::BoundaryFace& face = boundary.faces[mesh_.face[t]];
        triangles_[face.shell].push_back(t);
        Solid& solid = shells[face.shell];
        const Corners c = corners_of(mesh_, t);
        solid.volume_mm3 += dot(c[0], cross(c[1], c[2])) / 6.0;
        for (const Vec3& corner : c)
            solid.box.add(corner);
    }
    for (const cda::BoundaryFace& face : boundary.faces) {
        if (face.origin != cda::kStockOrigin) shells[face.shell].origins.push_back(face.origin);
    }
    for (std::uint32_t s = 0; s < shells.size(); ++s) {
        // A cavity is a surface turned inside out.
        if (shells[s].volume_mm3 <= 0.0) continue;
        auto& origins = shells[s].origins;
        std::ranges::sort(origins);
        origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
        shells[s].shell = s;
        solids_.push_back(std::move(shells[s]));
    }
    std::ranges::stable_sort(solids_, std::ranges::greater{}, &Solid::volume_mm3);
    for (std::size_t i = 0; i < solids_.size(); ++i)
        solids_[i].inner_point = point_in(i);
}

bool Solids::is_within(std::uint32_t shell, Vec3 point) const {
    // In no plane that programs make: a ray through an edge would count twice.
    constexpr Vec3 kDirection{0.5773241, 0.2113249, 0.7886751};
    std::size_t crossings = 0;
    for (const std::uint32_t t : triangles_[shell])
        crossings += crosses(point, kDirection, corners_of(mesh_, t)) ? 1 : 0;
    return crossings % 2 == 1;
}

std::optional<std::size_t> Solids::at(Vec3 point) const {
    // The smallest one around it: what stands free in a closed hollow is a piece of its own.
    for (std::size_t i = solids_.size(); i-- > 0;) {
        if (solids_[i].box.contains(point) && is_within(solids_[i].shell, point)) return i;
    }
    return std::nullopt;
}

// Below the middle of a large triangle, less and less deep until it is inside.
std::optional<Vec3> Solids::point_in(std::size_t solid) const {
    const Solid& s = solids_[solid];
    std::vector<std::pair<double, std::uint32_t>> large;
    for (const std::uint32_t t : triangles_[s.shell]) {
        const Corners c = corners_of(mesh_, t);
        large.emplace_back(-norm(cross(c[1] - c[0], c[2] - c[0])), t);
    }
    std::ranges::sort(large);
    if (large.size() > 8) large.resize(8);
    for (const auto& [area, t] : large) {
        const Corners c = corners_of(mesh_, t);
        const Vec3 middle = (1.0 / 3) * (c[0] + c[1] + c[2]);
        const Vec3 inward = -normalized(cross(c[1] - c[0], c[2] - c[0]));
        for (double depth = 0.3 * norm(s.box.size()); depth > 1e-6; depth /= 2) {
            const Vec3 p = middle + depth * inward;
            if (is_within(s.shell, p) && at(p) == solid) return p;
        }
    }
    return std::nullopt;
}

}  // namespace ncsim::verify
