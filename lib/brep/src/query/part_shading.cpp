// SPDX-License-Identifier: GPL-3.0-or-later
//
// 1. Assign a surface to each face (label.h). 2. Collect the surfaces around each vertex, each
// surface once for all its faces. 3. Take the normal of a round surface at the vertex; if adjacent
// surfaces continue in about the same direction, at the nearby point that lies on all of these
// surfaces.
#include "ncsim/brep/part_shading.h"

#include "geometry/no_index.h"
#include "geometry/tolerances.h"
#include "sources/label.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace ncsim::brep {

namespace {

bool is_flat(const Surface& surface) {
    return std::holds_alternative<Plane>(surface.form);
}

// Returns the largest radius of curvature, for a cone at `p`; infinity for planes.
double bend_of(const Form& form, Vec3 p) {
    if (std::holds_alternative<Plane>(form)) return std::numeric_limits<double>::infinity();
    const auto* cone = std::get_if<Cone>(&form);
    return cone ? norm(cross(p - cone->apex, cone->axis)) : radius_of(form);
}

// True if `p` is the tip of a cone, within the resolution of the lattice.
bool is_tip(const Form& form, Vec3 p) {
    return std::holds_alternative<Cone>(form) && bend_of(form, p) < kLeastSizeMm;
}

// Returns x with A x = b; A is symmetric and positive definite.
Vec3 solution(const std::array<Vec3, 3>& rows, Vec3 b) {
    const Vec3 c01 = cross(rows[0], rows[1]), c12 = cross(rows[1], rows[2]),
               c20 = cross(rows[2], rows[0]);
    const double det = dot(rows[0], c12);
    return (1.0 / det) * (b.x * c12 + b.y * c20 + b.z * c01);
}

// Returns the point near `p` that lies on all surfaces, or `p` if no such point is within `reach`.
// Newton's method has slight damping, because the normals of tangent surfaces do not determine a
// step.
Vec3 point_on_all(std::span<const Surface* const> surfaces, Vec3 p, double reach) {
    Vec3 at = p;
    double deviation = 0.0;
    for (int step = 0;; ++step) {
        const double damping = 100.0 * kRounding;
        std::array<Vec3, 3> rows{Vec3{damping, 0, 0}, Vec3{0, damping, 0}, Vec3{0, 0, damping}};
        Vec3 right;
        deviation = 0.0;
        for (const Surface* surface : surfaces) {
            const double d = distance(surface->form, at);
            const Vec3 g = gradient(surface->form, at);
            deviation = std::max(deviation, std::abs(d));
            right = right - d * g;
            for (int i = 0; i < 3; ++i)
                rows[static_cast<std::size_t>(i)] = rows[static_cast<std::size_t>(i)] + g[i] * g;
        }
        if (deviation <= kPointError || step == 12) break;
        at = at + solution(rows, right);
        if (!(norm(at - p) <= reach)) return p;
    }
    return deviation <= kLeastSizeMm ? at : p;
}

}  // namespace

ShadingMaker::ShadingMaker(const cda::Boundary& boundary)
    : boundary_(boundary), by_origin_(boundary) {
    shading_.of_face_.assign(boundary.faces.size(), kNone);
}

void ShadingMaker::take(cda::Origin origin, const SweptSurfaces& source) {
    const std::span<const Vec3> points(boundary_.vertices);
    std::vector<std::uint32_t> numbers(source.candidates.size(), kNone);
    for (const std::uint32_t f : by_origin_.of(origin)) {
        const cda::BoundaryFace& face = boundary_.faces[f];
        FlatFace flat{face.normal, {}, face.loops, points};
        area_of(face.loops, points, face.normal, flat.centroid);
        double best = std::numeric_limits<double>::infinity();
        // Corners where coarse hulls meet lie farther out than corners of solids by a factor of 2.
        // The direction of the normal decides between surfaces: a chord of 1 is 60°.
        const CandidateSurface* candidate =
            best_of(flat, source.candidates, 2.0 * source.error_mm, 1.0, best);
        if (!candidate) continue;
        std::uint32_t& number =
            numbers[static_cast<std::size_t>(candidate - source.candidates.data())];
        if (number == kNone) {
            number = static_cast<std::uint32_t>(shading_.surfaces_.size());
            shading_.surfaces_.push_back(candidate->surface);
            errors_.push_back(source.error_mm);
        }
        shading_.of_face_[f] = number;
    }
}

Shading ShadingMaker::finish() {
    const auto& of_face = shading_.of_face_;
    const auto& surfaces = shading_.surfaces_;
    // Surfaces around each vertex, with repetitions.
    std::vector<std::uint32_t> first(boundary_.vertices.size() + 1, 0);
    const auto for_each = [&](const auto& visit) {
        for (std::uint32_t f = 0; f < boundary_.faces.size(); ++f) {
            if (of_face[f] == kNone) continue;
            for (const auto& loop : boundary_.faces[f].loops) {
                for (const std::uint32_t v : loop)
                    visit(v, of_face[f]);
            }
        }
    };
    for_each([&](std::uint32_t v, std::uint32_t) { ++first[v + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> adjacent(first.back());
    std::vector<std::uint32_t> next(first);
    for_each([&](std::uint32_t v, std::uint32_t s) { adjacent[next[v]++] = s; });

    shading_.first_.reserve(first.size());
    std::vector<std::uint32_t> here;
    std::vector<const Surface*> joined;
    for (std::uint32_t v = 0; v < boundary_.vertices.size(); ++v) {
        shading_.first_.push_back(static_cast<std::uint32_t>(shading_.corners_.size()));
        here.assign(adjacent.begin() + first[v], adjacent.begin() + first[v + 1]);
        sort_unique(here);
        const Vec3 p = boundary_.vertices[v];
        for (const std::uint32_t s : here) {
            if (is_flat(surfaces[s])) continue;
            if (is_tip(surfaces[s].form, p)) {
                shading_.corners_.push_back({s, Vec3{}});
                continue;
            }
            const Vec3 own = outward(surfaces[s], p);
            joined.assign(1, &surfaces[s]);
            double bend = bend_of(surfaces[s].form, p), error = errors_[s];
            for (const std::uint32_t t : here) {
                if (t == s) continue;
                const double cosine = dot(own, outward(surfaces[t], p));
                // Surfaces that meet at less than 1° look like a single surface, and their crossing
                // is undetermined.
                if (cosine < kLeastShadingCosine || cosine > 0.99985) continue;
                joined.push_back(&surfaces[t]);
                bend = std::min(bend, bend_of(surfaces[t].form, p));
                error = std::max(error, errors_[t]);
            }
            if (joined.size() == 1) {
                shading_.corners_.push_back({s, own});
                continue;
            }
            // Width of facets that deviate by `error`.
            const double reach = std::sqrt(8.0 * bend * error);
            shading_.corners_.push_back({s, outward(surfaces[s], point_on_all(joined, p, reach))});
        }
    }
    shading_.first_.push_back(static_cast<std::uint32_t>(shading_.corners_.size()));
    return std::move(shading_);
}

const Surface* Shading::surface_of(std::uint32_t face) const {
    if (face >= of_face_.size() || of_face_[face] == kNone) return nullptr;
    return &surfaces_[of_face_[face]];
}

Shading::Recognition Shading::recognition(std::uint32_t face) const {
    if (face >= of_face_.size() || of_face_[face] == kNone) return Recognition::Unknown;
    return is_flat(surfaces_[of_face_[face]]) ? Recognition::Planar : Recognition::Curved;
}

Vec3 Shading::normal(std::uint32_t face, Vec3 own, std::uint32_t vertex, Vec3 point) const {
    const Vec3 n = normal_or_none(face, own, vertex, point);
    return n == Vec3{} ? own : n;
}

Vec3 Shading::normal_or_none(std::uint32_t face, Vec3 own, std::uint32_t vertex, Vec3 point) const {
    if (recognition(face) != Recognition::Curved) return own;
    const std::uint32_t s = of_face_[face];
    Vec3 n;
    if (vertex + 1 < first_.size()) {
        for (std::uint32_t i = first_[vertex]; i < first_[vertex + 1]; ++i) {
            if (corners_[i].surface == s) n = corners_[i].normal;
        }
    } else {
        n = outward(surfaces_[s], point);
    }
    return n != Vec3{} && dot(n, own) < kLeastShadingCosine ? own : n;
}

}  // namespace ncsim::brep
