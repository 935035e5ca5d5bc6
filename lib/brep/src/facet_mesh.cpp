// SPDX-License-Identifier: GPL-3.0-or-later
#include "facet_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ncsim::brep {

namespace {

using cda::cross;
using cda::dot;
using cda::norm;

// A facet and the surface it approximates turn away from each other by less, as a chord (0.45 rad).
constexpr double kMostTurn = 0.45;
// Of planes that are one but for rounding, as a chord.
constexpr double kLevel = 1e-6;
// Corners of hulls that meet may lie farther out than those of the tool.
constexpr double kSlack = 1.5;
// Of coils, beside walls, both beyond the wall and below the floor.
constexpr double kSlackOfCoils = 2.0;

double area_of(const cda::Boundary& boundary, const cda::BoundaryFace& face, Vec3& centroid) {
    const Vec3 apex = boundary.vertices[face.loops[0][0]];
    double sum = 0.0;
    Vec3 moment;
    for (const auto& loop : face.loops) {
        const Vec3 a = boundary.vertices[loop[0]] - apex;
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            const Vec3 b = boundary.vertices[loop[i]] - apex;
            const Vec3 c = boundary.vertices[loop[i + 1]] - apex;
            const double part = 0.5 * dot(cross(b - a, c - a), face.normal);
            sum += part;
            moment = moment + (part / 3.0) * (a + b + c);
        }
    }
    centroid = sum > 0.0 ? apex + (1.0 / sum) * moment : apex;
    return sum;
}

}  // namespace

FacetMesh::FacetMesh(const Facets& facets, const std::map<cda::Origin, Source>& sources,
                     std::span<const std::uint32_t> faces)
    : source_(facets) {
    for (const std::uint32_t f : faces)
        facets_.push_back(labelled(f, sources));
    link();
}

// How far a facet turns away from the surface: in its middle, or, where that is off the surface
// (of a ring: the bottom of a round groove), on average over its corners.
double FacetMesh::turn_from(const Facet& facet, const Surface& surface, double most) const {
    const auto at = [&](Vec3 p) { return norm(facet.normal - outward(surface, p)); };
    if (std::abs(distance(surface.form, facet.centroid)) <= most) return at(facet.centroid);
    double sum = 0.0, corners = 0.0;
    for (const auto& loop : source_.boundary.faces[facet.face].loops) {
        for (const std::uint32_t v : loop) {
            sum += at(source_.boundary.vertices[v]);
            corners += 1.0;
        }
    }
    return sum / corners;
}

bool FacetMesh::fits(const Facet& facet, const Surface& surface, double most, double most_turn,
                     double* score) const {
    const double turn = turn_from(facet, surface, most);
    if (turn > most_turn) return false;
    double farthest = 0.0;
    const auto* cone = std::get_if<Cone>(&surface.form);
    for (const auto& loop : source_.boundary.faces[facet.face].loops) {
        for (const std::uint32_t v : loop) {
            const Vec3 p = source_.boundary.vertices[v];
            farthest = std::max(farthest, std::abs(distance(surface.form, p)));
            if (farthest > most) return false;
            if (cone && dot(p - cone->apex, cone->axis) < -most) return false;
        }
    }
    if (score) *score = turn + 0.1 * farthest / most;
    return true;
}

Facet FacetMesh::labelled(std::uint32_t f, const std::map<cda::Origin, Source>& sources) {
    const cda::BoundaryFace& face = source_.boundary.faces[f];
    Facet facet;
    facet.face = f;
    facet.normal = face.normal;
    facet.area = area_of(source_.boundary, face, facet.centroid);
    facet.own = surfaces_.add_alone({Plane{facet.centroid, face.normal}, false});
    facet.label = facet.own;
    facet.may_be_true = true;
    double best = std::numeric_limits<double>::infinity();
    const Candidate* chosen = nullptr;
    for (const cda::Origin origin : source_.origins[f]) {
        const auto source = sources.find(origin);
        if (source == sources.end()) continue;
        if (!source->second.candidates.empty()) facet.may_be_true = false;
        facet.error_mm = std::max(facet.error_mm, source->second.error_mm);
        for (const Candidate& candidate : source->second.candidates) {
            // A surface that the tool went along is preferred to one where it only stood.
            constexpr double kAtRest = 0.05;
            double score = 0.0;
            const double slack =
                std::holds_alternative<Coil>(candidate.surface.form) ? kSlackOfCoils : kSlack;
            if (!fits(facet, candidate.surface, slack * source->second.error_mm, kMostTurn, &score))
                continue;
            // What is flat and lies on a plane of the tool is that: ramps may be flatter than
            // errors.
            constexpr double kExact = -1.0;
            if (std::holds_alternative<Plane>(candidate.surface.form) &&
                fits(facet, candidate.surface, kFlat, kLevel)) {
                score = kExact;
            }
            if (candidate.is_at_rest) score += kAtRest;
            if (score < best - 1e-9) {
                best = score;
                chosen = &candidate;
            }
        }
    }
    if (chosen) facet.label = surfaces_.add(chosen->surface);
    facet.was_labelled = chosen != nullptr;
    return facet;
}

std::size_t FacetMesh::given_up() const {
    return static_cast<std::size_t>(std::ranges::count_if(facets_, [](const Facet& facet) {
        return facet.was_labelled && facet.label == facet.own;
    }));
}

void FacetMesh::link() {
    std::vector<std::uint32_t> number(source_.boundary.vertices.size(), kNone);
    for (std::uint32_t i = 0; i < facets_.size(); ++i) {
        for (const auto& loop : source_.boundary.faces[facets_[i].face].loops) {
            const auto first = static_cast<std::uint32_t>(edges_.size());
            for (std::size_t k = 0; k < loop.size(); ++k) {
                std::uint32_t& v = number[loop[k]];
                if (v == kNone) {
                    v = static_cast<std::uint32_t>(points_.size());
                    points_.push_back(source_.boundary.vertices[loop[k]]);
                }
                const auto at = static_cast<std::uint32_t>(edges_.size());
                edges_.push_back({v, i, k + 1 < loop.size() ? at + 1 : first, kNone});
            }
        }
    }
    // Both of a pair have the same two corners.
    struct Ends {
        std::uint32_t low, high, edge;
        bool operator<(const Ends& o) const {
            return low != o.low ? low < o.low : high != o.high ? high < o.high : edge < o.edge;
        }
    };
    std::vector<Ends> ends;
    for (std::uint32_t h = 0; h < edges_.size(); ++h) {
        const auto [low, high] = std::minmax({edges_[h].from, to(h)});
        ends.push_back({low, high, h});
        lengths_.push_back(norm(points_[high] - points_[low]));
    }
    std::sort(ends.begin(), ends.end());
    broken_ = ends.size() % 2 != 0;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        const Ends &a = ends[i], &b = ends[i + 1];
        const bool is_next =
            i + 2 < ends.size() && ends[i + 2].low == a.low && ends[i + 2].high == a.high;
        if (a.low != b.low || a.high != b.high || is_next ||
            edges_[a.edge].from == edges_[b.edge].from) {
            broken_ = true;
            return;
        }
        edges_[a.edge].twin = b.edge;
        edges_[b.edge].twin = a.edge;
    }
}

}  // namespace ncsim::brep
