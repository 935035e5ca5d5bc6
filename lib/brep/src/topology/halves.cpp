// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/halves.h"

#include "geometry/none.h"

#include <cstddef>
#include <utility>
#include <variant>

namespace ncsim::brep {

namespace {

// At the knot in the middle, where there is one.
std::optional<Halves> spline_in_two(const Spline& spline) {
    const std::size_t knots = spline.knots.size();
    if (knots < 3) return std::nullopt;
    const std::size_t middle = knots / 2;
    const auto width = [&](std::size_t i) { return spline.knots[i + 1] - spline.knots[i]; };
    // Of both control points beside it, as far from each as the pieces are wide.
    const double before = width(middle - 1), after = width(middle);
    const Vec3 at = (1.0 / (before + after)) *
                    (after * spline.points[2 * middle] + before * spline.points[2 * middle + 1]);
    const auto split = [&](auto first, auto last) { return std::vector(first, last); };
    const auto points = [&](std::size_t i) {
        return spline.points.begin() + static_cast<std::ptrdiff_t>(i);
    };
    const auto knot = [&](std::size_t i) {
        return spline.knots.begin() + static_cast<std::ptrdiff_t>(i);
    };
    Spline first{split(points(0), points(2 * middle + 1)), split(knot(0), knot(middle + 1))};
    Spline second{split(points(2 * middle + 1), spline.points.end()),
                  split(knot(middle), spline.knots.end())};
    first.points.push_back(at);
    second.points.insert(second.points.begin(), at);
    for (double& k : second.knots)
        k -= spline.knots[middle];
    return Halves{at, std::move(first), std::move(second)};
}

}  // namespace

std::optional<Halves> edge_in_two(const Part& part, const Edge& edge, double at) {
    if (std::holds_alternative<Line>(edge.curve)) return std::nullopt;
    if (const auto* spline = std::get_if<Spline>(&edge.curve)) return spline_in_two(*spline);
    const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
    return Halves{track.at(at), edge.curve, edge.curve};
}

Halving::Halving(Part& part) : part_(part), second_(part.edges.size(), kNone) {}

bool Halving::halve(std::uint32_t number, double at) {
    if (number >= second_.size() || second_[number] != kNone) return false;
    const Edge edge = part_.edges[number];
    auto halves = edge_in_two(part_, edge, at);
    if (!halves) return false;
    const auto middle = static_cast<std::uint32_t>(part_.vertices.size());
    part_.vertices.push_back(halves->middle);
    second_[number] = static_cast<std::uint32_t>(part_.edges.size());
    part_.edges[number].to = middle;
    part_.edges[number].curve = std::move(halves->first);
    part_.edges.push_back({middle, edge.to, std::move(halves->second)});
    return true;
}

void Halving::finish() {
    for (Face& face : part_.faces) {
        for (Loop& loop : face.loops) {
            Loop halved;
            for (const EdgeUse& use : loop) {
                const std::uint32_t other = use.edge < second_.size() ? second_[use.edge] : kNone;
                if (other != kNone && !use.is_forward) halved.push_back({other, false});
                halved.push_back(use);
                if (other != kNone && use.is_forward) halved.push_back({other, true});
            }
            loop = std::move(halved);
        }
    }
}

}  // namespace ncsim::brep
