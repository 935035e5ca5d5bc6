// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact difference of convex bodies by clipping.
#include "polytope/difference.h"

#include <utility>

namespace ncsim::cda {

namespace {

// Returns the parts of `body` outside of `other`; no value without a common volume.
std::optional<std::vector<ConvexPolytope>> parts_outside(const ConvexPolytope& body,
                                                         const ConvexPolytope& other) {
    if (!body.bounds().overlaps(other.bounds())) return std::nullopt;
    std::vector<ConvexPolytope> outside;
    ConvexPolytope inside = body;
    for (const auto& facet : other.facets()) {
        auto next = inside.clip(facet.plane);
        if (!next) return std::nullopt;
        if (auto part = inside.clip(facet.plane.opposite())) outside.push_back(std::move(*part));
        inside = std::move(*next);
    }
    return outside;
}

}  // namespace

std::optional<ConvexPolytope> first_of_difference(
    const ConvexPolytope& body, std::span<const ConvexPolytope* const> taken,
    const std::function<bool(const ConvexPolytope&)>& accept) {
    // Depth-first search with a stack of pieces, each with the number of subtracted bodies. Memory
    // is the depth times the pieces of a cut.
    std::vector<std::pair<ConvexPolytope, std::size_t>> stack;
    stack.emplace_back(body, 0);
    while (!stack.empty()) {
        auto [piece, done] = std::move(stack.back());
        stack.pop_back();
        bool survived = true;
        for (std::size_t i = done; i < taken.size(); ++i) {
            auto parts = parts_outside(piece, *taken[i]);
            if (!parts) continue;
            for (auto part = parts->rbegin(); part != parts->rend(); ++part) {
                stack.emplace_back(std::move(*part), i + 1);
            }
            survived = false;
            break;
        }
        if (survived && accept(piece)) return std::move(piece);
    }
    return std::nullopt;
}

std::vector<ConvexPolytope> difference(const ConvexPolytope& body,
                                       std::span<const ConvexPolytope* const> taken) {
    std::vector<ConvexPolytope> pieces;
    first_of_difference(body, taken, [&](const ConvexPolytope& piece) {
        pieces.push_back(piece);
        return false;
    });
    return pieces;
}

Vec3 inner_point(const ConvexPolytope& body) {
    Vec3 sum;
    for (const ExactPoint& v : body.vertices())
        sum = sum + v.approx;
    return (1.0 / static_cast<double>(body.vertices().size())) * sum;
}

}  // namespace ncsim::cda
