// SPDX-License-Identifier: GPL-3.0-or-later
#include "pieces.h"

#include <numeric>

namespace ncsim::exporter {

Pieces::Pieces(const cda::Boundary& boundary)
    : boundary_(boundary), first_(boundary.faces.size() + 1, 0) {
    cda::Boundary pierced;
    std::vector<std::uint32_t> original;  // number of each face of `pierced` in `boundary`
    for (std::uint32_t f = 0; f < boundary.faces.size(); ++f) {
        if (!has_holes(f)) continue;
        pierced.faces.push_back(boundary.faces[f]);
        original.push_back(f);
    }
    if (original.empty()) return;
    pierced.vertices = boundary.vertices;
    mesh_ = cda::triangulate(pierced);
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
    return has_holes(face) ? first_[face + 1] - first_[face] : 1;
}

std::span<const std::uint32_t> Pieces::corners(std::uint32_t face, std::size_t i) const {
    if (!has_holes(face)) return boundary_.faces[face].loops.front();
    return mesh_.triangles[sorted_[first_[face] + i]];
}

}  // namespace ncsim::exporter
