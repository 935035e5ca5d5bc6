// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splitting of circles, ellipses and splines.
#include "topology/edge_splitter.h"

#include "geometry/no_index.h"
#include "topology/divided_spline.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>

namespace ncsim::brep {

namespace {

// Returns `at`, or the share of an inner knot nearer than a thousandth of the piece.
double near_knot(const Spline& spline, double at) {
    const auto& k = spline.knots;
    const double length = k.back() - k.front(), place = k.front() + at * length;
    const std::size_t i = piece_at(spline, place);
    const double width = k[i + 1] - k[i];
    if (place - k[i] < 1e-3 * width && i > 0) return (k[i] - k.front()) / length;
    if (k[i + 1] - place < 1e-3 * width && i + 2 < k.size()) return (k[i + 1] - k.front()) / length;
    return at;
}

}  // namespace

std::optional<EdgeHalves> split_edge(const Part& part, const Edge& edge, double at) {
    if (std::holds_alternative<Line>(edge.curve)) return std::nullopt;
    if (const auto* spline = std::get_if<Spline>(&edge.curve)) {
        const auto& k = spline->knots;
        if (k.size() < 3) return std::nullopt;
        return divide_edge(part, edge, (k[k.size() / 2] - k.front()) / (k.back() - k.front()));
    }
    const Track track = track_of(part, edge);
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
    return replace(number, spline ? divide_edge(part_, edge, near_knot(*spline, at))
                                  : split_edge(part_, edge, at));
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
