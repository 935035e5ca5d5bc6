// SPDX-License-Identifier: GPL-3.0-or-later
//
// Crossings by bisection between extreme heights of an edge.
#include "topology/crossings.h"

#include "geometry/tolerances.h"

#include <cmath>
#include <cstddef>

namespace ncsim::brep {

namespace {

class Heights {
public:
    Heights(const Part& part, const Edge& edge, const CutPlane& plane)
        : plane_(plane),
          from_(part.vertices[edge.from]),
          to_(part.vertices[edge.to]),
          track_(edge.curve, from_, to_) {}

    Vec3 point(double t) const { return t <= 0.0 ? from_ : t >= 1.0 ? to_ : track_.at(t); }
    double operator()(double t) const { return plane_.height(point(t)); }
    double slope(double t) const { return dot(plane_.normal, track_.derivative(t)); }
    std::size_t pieces() const { return track_.pieces(); }

    // Returns the parameter at which the height is `height`, between parameters with heights on
    // both sides.
    double reach(double begin, double end, double height) const {
        const bool is_above = (*this)(begin) > height;
        for (int i = 0; i < kMostSteps; ++i) {
            const double middle = 0.5 * (begin + end);
            (((*this)(middle) > height) == is_above ? begin : end) = middle;
        }
        return 0.5 * (begin + end);
    }

private:
    CutPlane plane_;
    Vec3 from_, to_;
    Track track_;
};

// Returns parameters between which the edge only rises or only falls.
std::vector<double> turns_of(const Heights& height) {
    const std::size_t steps = 4 * height.pieces();
    std::vector<double> turns{0.0};
    double last = height.slope(0.0);
    for (std::size_t i = 1; i <= steps; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(steps);
        const double slope = height.slope(t);
        if ((slope > 0.0) != (last > 0.0)) {
            double begin = static_cast<double>(i - 1) / static_cast<double>(steps), end = t;
            for (int k = 0; k < kMostSteps; ++k) {
                const double middle = 0.5 * (begin + end);
                ((height.slope(middle) > 0.0) == (last > 0.0) ? begin : end) = middle;
            }
            turns.push_back(0.5 * (begin + end));
        }
        last = slope;
    }
    turns.push_back(1.0);
    return turns;
}

}  // namespace

std::vector<Crossing> crossings_of(const Part& part, const Edge& edge, const CutPlane& plane,
                                   double lift) {
    const Heights height(part, edge, plane);
    const bool is_line = std::holds_alternative<Line>(edge.curve);
    if (is_line && (height(0.0) > lift) == (height(1.0) > lift)) return {};
    const std::vector<double> turns = is_line ? std::vector<double>{0.0, 1.0} : turns_of(height);
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
        const double begin = turns[i], end = turns[i + 1];
        const double first = height(begin), last = height(end);
        if ((first > lift) == (last > lift)) continue;
        Crossing crossing;
        crossing.goes_up = last > lift;
        crossing.above = height.point(height.reach(begin, end, lift));
        // The edge passes the plane itself, or only comes near.
        if ((first > 0.0) != (last > 0.0)) {
            crossing.at = height.point(height.reach(begin, end, 0.0));
        } else {
            crossing.at = height.point(crossing.goes_up ? begin : end);
        }
        crossings.push_back(crossing);
    }
    return crossings;
}

}  // namespace ncsim::brep
