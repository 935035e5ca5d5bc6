// SPDX-License-Identifier: GPL-3.0-or-later
#include "pieces.h"

#include <numeric>

namespace ncsim::exporter {

namespace {

using cda::Vec3;

// Right turns of less than this (a sine) come from rounding and spoil no fan.
constexpr double kStraight = 1e-7;

bool is_convex(const cda::Boundary& boundary, const cda::BoundaryFace& face) {
    if (face.loops.size() > 1) return false;
    const auto& loop = face.loops.front();
    if (loop.size() == 3) return true;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 a = boundary.vertices[loop[i]];
        const Vec3 b = boundary.vertices[loop[(i + 1) % loop.size()]];
        const Vec3 c = boundary.vertices[loop[(i + 2) % loop.size()]];
        const double turn =
            cda::dot(face.normal, cda::cross(cda::normalized(b - a), cda::normalized(c - b)));
        if (turn < -kStraight) return false;
    }
    return true;
}

}  // namespace

Pieces::Pieces(const cda::Boundary& boundary)
    : boundary_(boundary), first_(boundary.faces.size() + 1, 0) {
    for (const cda::BoundaryFace& face : boundary.faces)
        is_cut_.push_back(!is_convex(boundary, face));
    cda::Boundary concave;
    std::vector<std::uint32_t> original;  // number of each face of `concave` in `boundary`
    for (std::uint32_t f = 0; f < boundary.faces.size(); ++f) {
        if (!is_cut(f)) continue;
        concave.faces.push_back(boundary.faces[f]);
        original.push_back(f);
    }
    if (original.empty()) return;
    concave.vertices = boundary.vertices;
    mesh_ = cda::triangulate(concave);
    for (const std::uint32_t face : mesh_.face)
        ++first_[original[face] + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    sorted_.resize(mesh_.triangles.size());
    std::vector<std::uint32_t> next(first_);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        sorted_[next[original[mesh_.face[t]]]++] = t;
    }
}

std::size_t Pieces::count(std::uint32_t face) const {
    return is_cut(face) ? first_[face + 1] - first_[face] : 1;
}

std::span<const std::uint32_t> Pieces::corners(std::uint32_t face, std::size_t i) const {
    if (!is_cut(face)) return boundary_.faces[face].loops.front();
    return mesh_.triangles[sorted_[first_[face] + i]];
}

}  // namespace ncsim::exporter
