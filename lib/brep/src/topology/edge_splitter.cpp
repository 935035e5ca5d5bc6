// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splitting of circles, ellipses and splines.
#include "topology/edge_splitter.h"

#include "geometry/no_index.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>

namespace ncsim::brep {

namespace {

// Splits the spline at an inner knot.
EdgeHalves split_spline(const Spline& spline, std::size_t middle) {
    const auto width = [&](std::size_t i) { return spline.knots[i + 1] - spline.knots[i]; };
    // Divides the segment between the adjacent control points in the ratio of the adjacent pieces.
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
    return EdgeHalves{at, std::move(first), std::move(second)};
}

// Splits the spline at the middle knot, if there is an inner knot.
std::optional<EdgeHalves> split_spline(const Spline& spline) {
    const std::size_t knots = spline.knots.size();
    if (knots < 3) return std::nullopt;
    return split_spline(spline, knots / 2);
}

// Splits the spline at any place: the cubic there becomes two cubics on the same curve.
EdgeHalves split_spline(const Part& part, const Edge& edge, const Spline& spline, double at) {
    const auto& k = spline.knots;
    const double place = k.front() + at * (k.back() - k.front());
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(k, place) - k.begin());
    const std::size_t i = std::clamp<std::size_t>(after, 1, k.size() - 1);
    // A knot this near to the place is the place.
    const double width = k[i] - k[i - 1];
    if (place - k[i - 1] < 1e-3 * width && i > 1) return split_spline(spline, i - 1);
    if (k[i] - place < 1e-3 * width && i + 1 < k.size()) return split_spline(spline, i);
    const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
    const Track::Step step = track.step(at);
    const Vec3 third = (1.0 / (3.0 * (k.back() - k.front()))) * step.derivative;
    Spline finer = spline;
    // The inner control points of the piece move towards its ends in proportion to the new widths.
    const std::size_t first = 2 * i - 1;
    const double before = place - k[i - 1], rest = k[i] - place;
    const Vec3 from = track.at((k[i - 1] - k.front()) / (k.back() - k.front()));
    const Vec3 to = track.at((k[i] - k.front()) / (k.back() - k.front()));
    finer.points[first] = from + (before / width) * (spline.points[first] - from);
    finer.points[first + 1] = to + (rest / width) * (spline.points[first + 1] - to);
    const auto where = finer.points.begin() + static_cast<std::ptrdiff_t>(first + 1);
    finer.points.insert(where, {step.at - before * third, step.at + rest * third});
    finer.knots.insert(finer.knots.begin() + static_cast<std::ptrdiff_t>(i), place);
    return split_spline(finer, i);
}

}  // namespace

std::optional<EdgeHalves> split_edge(const Part& part, const Edge& edge, double at) {
    if (std::holds_alternative<Line>(edge.curve)) return std::nullopt;
    if (const auto* spline = std::get_if<Spline>(&edge.curve)) return split_spline(*spline);
    const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
    return EdgeHalves{track.at(at), edge.curve, edge.curve};
}

EdgeSplitter::EdgeSplitter(Part& part) : part_(part), second_(part.edges.size(), kNone) {}

bool EdgeSplitter::halve(std::uint32_t number, double at) {
    if (number >= second_.size() || second_[number] != kNone) return false;
    return replace(number, split_edge(part_, part_.edges[number], at));
}

bool EdgeSplitter::divide(std::uint32_t number, double at) {
    if (number >= second_.size() || second_[number] != kNone) return false;
    const Edge& edge = part_.edges[number];
    const auto* spline = std::get_if<Spline>(&edge.curve);
    return replace(number,
                   spline ? split_spline(part_, edge, *spline, at) : split_edge(part_, edge, at));
}

bool EdgeSplitter::replace(std::uint32_t number, std::optional<EdgeHalves> halves) {
    if (!halves) return false;
    const Edge edge = part_.edges[number];
    const auto middle = static_cast<std::uint32_t>(part_.vertices.size());
    part_.vertices.push_back(halves->middle);
    second_[number] = static_cast<std::uint32_t>(part_.edges.size());
    part_.edges[number].to = middle;
    part_.edges[number].curve = std::move(halves->first);
    part_.edges.push_back({middle, edge.to, std::move(halves->second)});
    return true;
}

void EdgeSplitter::finish() {
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
