// SPDX-License-Identifier: GPL-3.0-or-later
#include "heal/fine_splines.h"

#include "geometry/newton.h"
#include "geometry/tolerances.h"
#include "query/part_check.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace ncsim::brep {

namespace {

// Point of a spline with the derivative by the parameter.
struct SplineKnot {
    double t = 0.0;
    Vec3 at, derivative;
};

// Returns point and derivative of the cubic between two knots at the share `s` of the interval.
SplineKnot between(const SplineKnot& from, const SplineKnot& to, double s) {
    const double width = to.t - from.t, r = 1.0 - s;
    const Vec3 first = width * from.derivative, last = width * to.derivative;
    const Vec3 chord = to.at - from.at;
    return {from.t + s * width,
            (r * r * (1.0 + 2.0 * s)) * from.at + (s * r * r) * first +
                (s * s * (3.0 - 2.0 * s)) * to.at - (s * s * r) * last,
            (1.0 / width) * ((6.0 * s * r) * chord + (r * (1.0 - 3.0 * s)) * first +
                             (s * (3.0 * s - 2.0)) * last)};
}

// Returns the knots of a spline with the derivatives that follow from the control points.
std::vector<SplineKnot> knots_of(const Spline& spline) {
    const auto& p = spline.points;
    const auto& k = spline.knots;
    const std::size_t last = k.size() - 1;
    std::vector<SplineKnot> knots{{k.front(), p.front(), (3.0 / (k[1] - k[0])) * (p[1] - p[0])}};
    for (std::size_t i = 1; i < last; ++i) {
        const double before = k[i] - k[i - 1], after = k[i + 1] - k[i];
        const Vec3 &in = p[2 * i], &out = p[2 * i + 1];
        knots.push_back({k[i], (1.0 / (before + after)) * (after * in + before * out),
                         (3.0 / (before + after)) * (out - in)});
    }
    knots.push_back(
        {k[last], p.back(), (3.0 / (k[last] - k[last - 1])) * (p.back() - p[2 * last])});
    return knots;
}

Spline spline_through(const std::vector<SplineKnot>& knots) {
    Spline spline;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const SplineKnot& k = knots[i];
        const auto handle = [&](const SplineKnot& other) {
            return k.at + ((other.t - k.t) / 3.0) * k.derivative;
        };
        spline.points.push_back(i == 0 ? k.at : handle(knots[i - 1]));
        spline.points.push_back(i + 1 == knots.size() ? k.at : handle(knots[i + 1]));
        spline.knots.push_back(k.t);
    }
    return spline;
}

class Refiner {
public:
    Refiner(const Form& a, const Form& b) : forms_{&a, &b} {}

    // Returns the spline with more knots; no value if no piece is divided.
    std::optional<Spline> operator()(const Spline& spline) {
        const std::vector<SplineKnot> knots = knots_of(spline);
        std::vector<SplineKnot> finer{knots.front()}, piece;
        for (std::size_t i = 1; i < knots.size(); ++i) {
            piece.clear();
            if (!divide(knots[i - 1], knots[i], 5, piece)) piece = {knots[i]};
            finer.insert(finer.end(), piece.begin(), piece.end());
        }
        if (finer.size() == knots.size()) return std::nullopt;
        return spline_through(finer);
    }

private:
    double deviation(Vec3 p) {
        return std::max(std::abs(distance(*forms_[0], p, seeds_[0])),
                        std::abs(distance(*forms_[1], p, seeds_[1])));
    }

    bool divide(const SplineKnot& from, const SplineKnot& to, int halvings,
                std::vector<SplineKnot>& knots) {
        const bool is_fine = std::ranges::all_of(std::array{0.2, 0.4, 0.6, 0.8}, [&](double s) {
            return deviation(between(from, to, s).at) <= 0.5 * kReaderMm;
        });
        if (is_fine) {
            knots.push_back(to);
            return true;
        }
        if (halvings == 0) return false;
        const auto middle = on_both(between(from, to, 0.5));
        return middle && divide(from, *middle, halvings - 1, knots) &&
               divide(*middle, to, halvings - 1, knots);
    }

    // Moves a knot onto both forms, perpendicular to the curve. If the forms are tangent along the
    // curve, the knot moves along the common normal only, and the derivative stays. No value if the
    // knot remains off a form or moves by more than kLeastSizeMm.
    std::optional<SplineKnot> on_both(SplineKnot knot) {
        const Vec3 start = knot.at;
        const auto normals = [&] {
            return std::array{evaluate(*forms_[0], knot.at, seeds_[0]),
                              evaluate(*forms_[1], knot.at, seeds_[1])};
        };
        const auto sees = normals();
        if (norm(cross(sees[0].gradient, sees[1].gradient)) > 10.0 * kLeastSine) {
            const Form across = Plane{knot.at, normalized(knot.derivative)};
            const std::array<const Form*, 3> three{forms_[0], forms_[1], &across};
            solve(three, knot.at, seeds_);
            const auto there = normals();
            const Vec3 along = normalized(cross(there[0].gradient, there[1].gradient));
            const double speed = norm(knot.derivative);
            knot.derivative = (dot(along, knot.derivative) < 0.0 ? -speed : speed) * along;
        } else {
            for (int i = 0; i < 4; ++i) {
                const auto [distance, gradient] =
                    evaluate(*forms_[static_cast<std::size_t>(i % 2)], knot.at, seeds_[0]);
                knot.at = knot.at - distance * gradient;
            }
        }
        if (!(deviation(knot.at) <= 0.5 * kReaderMm) || norm(knot.at - start) > kLeastSizeMm)
            return std::nullopt;
        return knot;
    }

    std::array<const Form*, 2> forms_;
    std::array<ProjectionSeed, 3> seeds_;  // For both forms and the plane across the curve.
};

// True if all edges of the face end in their corners, except for rounding.
bool ends_in_corners(const Part& part, const Face& face) {
    return std::ranges::all_of(uses_of(face), [&](const EdgeUse& use) {
        const Edge& edge = part.edges[use.edge];
        const Track track = track_of(part, edge);
        return norm(track.at(0.0) - part.vertices[edge.from]) <= kRounding &&
               norm(track.at(1.0) - part.vertices[edge.to]) <= kRounding;
    });
}

}  // namespace

void refine_splines(Part& part) {
    const auto faces = sides_of_edges(part);
    std::vector<std::optional<Curve>> before(part.edges.size());
    std::set<std::uint32_t> changed;  // faces
    for (std::uint32_t e = 0; e < part.edges.size(); ++e) {
        const auto [f, g] = faces[e];
        const auto* spline = std::get_if<Spline>(&part.edges[e].curve);
        const std::size_t count = part.faces.size();
        if (!spline || f >= count || g >= count || f == g) continue;
        if (part.faces[f].is_facet || part.faces[g].is_facet) continue;
        Refiner refine(part.faces[f].surface.form, part.faces[g].surface.form);
        auto finer = refine(*spline);
        if (!finer) continue;
        before[e] = std::exchange(part.edges[e].curve, std::move(*finer));
        changed.insert({f, g});
    }
    // Restores the old curves of faces with faults: a finer edge may cross another edge, but only
    // near a corner that is off the curve.
    while (!changed.empty()) {
        const std::uint32_t f = *changed.begin();
        changed.erase(changed.begin());
        if (ends_in_corners(part, part.faces[f])) continue;
        double miss = 0.0;
        if (faults_of(part, f, kTangencyGapMm, miss).empty()) continue;
        for (const EdgeUse& use : uses_of(part.faces[f])) {
            if (!before[use.edge]) continue;
            part.edges[use.edge].curve = std::move(*before[use.edge]);
            before[use.edge].reset();
            const auto [a, b] = faces[use.edge];
            changed.insert(a == f ? b : a);
        }
    }
}

}  // namespace ncsim::brep
