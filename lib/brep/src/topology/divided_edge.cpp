// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/brep/divided_edge.h"

#include "topology/divided_spline.h"
#include "topology/face_edges.h"

#include <utility>
#include <variant>

namespace ncsim::brep {

namespace {

template <class Curve>
std::array<Curve, 2> divided(const Curve& curve, double at) {
    const auto& k = curve.knots;
    return divided_at(curve, k.front() + at * (k.back() - k.front()));
}

// Shifts all knots of a curve, so that the first knot becomes `begin`.
template <class Curve>
void begin_at(Curve& curve, double begin) {
    const double shift = begin - curve.knots.front();
    for (double& knot : curve.knots)
        knot += shift;
}

}  // namespace

EdgeHalves divide_edge(const Part& part, const Edge& edge, double at) {
    if (const auto* spline = std::get_if<Spline>(&edge.curve)) {
        auto halves = divided(*spline, at);
        begin_at(halves[1], 0.0);
        return {halves[1].points.front(), std::move(halves[0]), std::move(halves[1])};
    }
    const Track track = track_of(part, edge);
    return {point_in_file(track, track.at(at)), edge.curve, edge.curve};
}

std::array<ParameterCurve, 2> divide_curve(const ParameterCurve& curve, const Part& part,
                                           const Edge& edge, double at) {
    auto halves = divided(curve, at);
    begin_at(halves[1], ParameterSurface::begin_of_rest(part, edge, at));
    return halves;
}

}  // namespace ncsim::brep
