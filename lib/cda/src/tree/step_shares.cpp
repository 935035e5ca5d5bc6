// SPDX-License-Identifier: GPL-3.0-or-later
//
// Integration of the time at which a body reaches a facet.
#include "tree/step_shares.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ncsim::cda {

namespace {

using Point = FacetRegion::Point;
using Line = FacetRegion::Line;

struct Span {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

Span span_of(const Line& line, std::span<const Point> polygon) {
    Span span;
    for (const Point& p : polygon) {
        const double value = line.above(p);
        span.low = std::min(span.low, value);
        span.high = std::max(span.high, value);
    }
    return span;
}

// Integral of a linear function over a convex polygon, by a triangle fan.
struct Integral {
    double area = 0.0, value = 0.0;
};
Integral integral(std::span<const Point> p, const Line& line) {
    Integral sum;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        const double doubled = cross(p[i] - p[0], p[i + 1] - p[0]);
        const double area = 0.5 * std::abs(doubled);
        sum.area += area;
        sum.value += area * (line.above(p[0]) + line.above(p[i]) + line.above(p[i + 1])) / 3.0;
    }
    return sum;
}

// Computes the part of a polygon above or below the line.
void cut_polygon(std::span<const Point> polygon, const Line& line, bool above,
                 std::vector<Point>& part) {
    const double sign = above ? 1.0 : -1.0;
    part.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& p = polygon[i];
        const Point& q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
        const double at_p = sign * line.above(p);
        const double at_q = sign * line.above(q);
        if (at_p >= 0.0) part.push_back(p);
        if ((at_p < 0.0 && at_q > 0.0) || (at_p > 0.0 && at_q < 0.0)) {
            const double t = at_p / (at_p - at_q);
            part.push_back(p + t * (q - p));
        }
    }
}

}  // namespace

StepShares::StepShares(const IncomingCell& cell)
    : steps_(cell.steps),
      shares_(cell.steps->steps.size(), 0.0),
      areas_before_(cell.steps->steps.size() + 1, 0.0) {
    for (const Plane& plane : cell.planes.first(cell.facets.size())) {
        const double along = along_way(plane);
        if (along > 0.0) forward_planes_.push_back({&plane, along});
    }
}

// Returns n·way. Exact: normals have 24 bits, ways 26.
double StepShares::along_way(const Plane& plane) const {
    const LatticePoint& w = steps_->way;
    return static_cast<double>(plane.nx * w.x + plane.ny * w.y + plane.nz * w.z);
}

void StepShares::add_wall(const Plane& plane, double area) {
    const double along = along_way(plane);
    if (along <= 0.0) return;
    const double length = std::sqrt(static_cast<double>(plane.nx) * plane.nx +
                                    static_cast<double>(plane.ny) * plane.ny +
                                    static_cast<double>(plane.nz) * plane.nz);
    areas_before_.back() += along / length * area;
}

void StepShares::add_removed(const Plane& plane, double sign, const FacetRegion& facet,
                             std::span<const FacetRegion::Polygon> polygons) {
    const double along = along_way(plane);
    if (along == 0.0 || polygons.empty()) return;
    weight_ = sign * facet.flattened(along);
    times_.clear();
    for (const ForwardPlane& front : forward_planes_) {
        const Line line = facet.line_of(*front.plane);
        times_.push_back({line.a / front.along, line.b / front.along, line.c / front.along - 1.0});
    }
    for (const FacetRegion::Polygon& polygon : polygons)
        enqueue(facet.corners(polygon));
}

// Divides the polygon by the front that arrives last; the first front among equals.
void StepShares::enqueue(std::span<const Point> polygon) {
    if (polygon.size() < 3) return;
    double latest_low = -std::numeric_limits<double>::infinity();
    double latest = latest_low;
    for (const Line& time : times_) {
        const Span span = span_of(time, polygon);
        latest_low = std::max(latest_low, span.low);
        latest = std::max(latest, span.high);
    }
    if (latest <= steps_->steps[0].end) return;
    last_.clear();
    for (const Line& time : times_) {
        const Span span = span_of(time, polygon);
        if (span.high > latest_low || span.low == latest_low) last_.push_back(time);
    }
    if (last_.size() == 1) return enqueue(polygon, last_[0]);
    for (std::size_t i = 0; i < last_.size(); ++i) {
        part_.assign(polygon.begin(), polygon.end());
        bool is_there = true;
        for (std::size_t k = 0; k < last_.size() && is_there; ++k) {
            if (k == i) continue;
            const Line &first = last_[std::min(i, k)], &second = last_[std::max(i, k)];
            is_there = clip({first.a - second.a, first.b - second.b, first.c - second.c}, i < k);
        }
        if (is_there) enqueue(part_, last_[i]);
    }
}

// Clips part_ to the side above (or on) the line, or below; false if the result is empty.
bool StepShares::clip(const Line& line, bool above) {
    const Span span = span_of(line, part_);
    if (above ? span.low >= 0.0 : span.high < 0.0) return true;
    if (above ? span.high < 0.0 : span.low >= 0.0) return false;
    cut_polygon(part_, line, above, cut_);
    part_.swap(cut_);
    return part_.size() >= 3;
}

// Adds a polygon at whose points the body arrives at `time`.
void StepShares::enqueue(std::span<const Point> polygon, const Line& time) {
    const auto& steps = steps_->steps;
    const Span span = span_of(time, polygon);
    const auto after = [&](double at) {
        const Line later{time.a, time.b, time.c + at};
        if (span.high <= at) return 0.0;
        if (span.low >= at) return integral(polygon, later).value;
        cut_polygon(polygon, later, true, cut_);
        return integral(cut_, later).value;
    };
    const auto ends_after = [](double at, const auto& step) { return at < step.end; };
    auto i = static_cast<std::size_t>(
        std::upper_bound(steps.begin(), steps.end(), span.low, ends_after) - steps.begin());
    areas_before_[i] += weight_ * integral(polygon, time).area;
    for (i = std::max<std::size_t>(i, 1); i < steps.size() && steps[i - 1].end < span.high; ++i)
        shares_[i] += weight_ * (after(steps[i - 1].end) - after(steps[i].end));
}

std::vector<double> StepShares::of(double whole) const {
    const auto& steps = steps_->steps;
    std::vector<double> all = shares_;
    double later = 0.0;
    double others = 0.0;
    for (std::size_t i = steps.size() - 1; i > 0; --i) {
        later += areas_before_[i + 1];
        all[i] += later * (steps[i].end - steps[i - 1].end);
        others += all[i];
    }
    all[0] = whole - others;
    return all;
}

}  // namespace ncsim::cda
