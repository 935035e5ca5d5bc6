// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decision which faces are split into triangles, and the triangles.
#include "ncsim/mesh/pieces.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/triangulate.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace ncsim::mesh {

namespace {

// Largest sine of a right turn that counts as a rounding error and is harmless in a fan.
constexpr double kStraight = 1e-7;

bool is_convex(const cda::Boundary& boundary, const cda::BoundaryFace& face) {
    if (face.loops.size() > 1) return false;
    const auto& loop = face.loops.front();
    if (loop.size() == 3) return true;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 a = boundary.vertices[loop[i]];
        const Vec3 b = boundary.vertices[loop[(i + 1) % loop.size()]];
        const Vec3 c = boundary.vertices[loop[(i + 2) % loop.size()]];
        const double turn = dot(face.normal, cross(normalized(b - a), normalized(c - b)));
        if (turn < -kStraight) return false;
    }
    return true;
}

using Triangle = std::array<std::uint32_t, 3>;

// Distance in mm below which tessellators (such as Coin) identify two places of an
// outline.
constexpr double kTouching = 1e-3;

bool is_low(const std::vector<Vec3>& vertices, const Triangle& t) {
    const Vec3 ab = vertices[t[1]] - vertices[t[0]];
    const Vec3 ac = vertices[t[2]] - vertices[t[0]];
    const Vec3 bc = vertices[t[2]] - vertices[t[1]];
    const double longest = std::max({norm(ab), norm(ac), norm(bc)});
    return norm(cross(ab, ac)) < kTouching * longest;
}

// True if the loop has a nearly straight corner, which only adjacent faces need.
bool has_straight_corner(const std::vector<Vec3>& vertices,
                         const std::vector<std::uint32_t>& loop) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (n > 3 && is_low(vertices, {loop[i], loop[(i + 1) % n], loop[(i + 2) % n]})) return true;
    }
    return false;
}

}  // namespace

Pieces::Pieces(const cda::Boundary& boundary)
    : boundary_(boundary), first_(boundary.faces.size() + 1, 0) {
    // Triangulates all faces together, so no diagonal of a face is an edge of another face.
    TriangleMesh mesh = cda::triangulate(boundary);
    vertices_ = std::move(mesh.vertices);
    std::vector<std::vector<Triangle>> triangles(boundary.faces.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        triangles[mesh.face[t]].push_back(mesh.triangles[t]);
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        const bool is_fan = is_convex(boundary, boundary.faces[f]);
        // An outline that comes close to itself has low triangles there.
        const bool touches = std::any_of(triangles[f].begin(), triangles[f].end(),
                                         [&](const Triangle& t) { return is_low(vertices_, t); });
        const auto& loops = boundary.faces[f].loops;
        if (is_fan && !touches && !has_straight_corner(vertices_, loops.front())) continue;
        pieces_.insert(pieces_.end(), triangles[f].begin(), triangles[f].end());
        first_[f + 1] = static_cast<std::uint32_t>(triangles[f].size());
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

std::size_t Pieces::count(std::uint32_t face) const {
    return std::max(1U, first_[face + 1] - first_[face]);
}

std::span<const std::uint32_t> Pieces::corners(std::uint32_t face, std::size_t i) const {
    if (first_[face + 1] == first_[face]) return boundary_.faces[face].loops.front();
    return pieces_[first_[face] + i];
}

}  // namespace ncsim::mesh
