// SPDX-License-Identifier: GPL-3.0-or-later
//
// Orientation and containment of loops, with a filter in doubles and rational arithmetic.
#include "surface/loops.h"

#include "ncsim/base/vec2.h"

#include "exact/wide.h"

#include <gmpxx.h>

#include <cmath>
#include <cstddef>
#include <optional>

namespace ncsim::cda {

namespace {

struct ExactFlat {
    mpq_class s, t;
};

mpz_class integer(Int128 v) {
    const UInt128 m = magnitude(v);
    mpz_class result = static_cast<unsigned long>(m >> 64);
    result <<= 64;
    result += static_cast<unsigned long>(m);
    return v < 0 ? mpz_class(-result) : result;
}

mpq_class quotient(Int128 p, Int128 q) {
    mpq_class result(integer(p), integer(q));
    result.canonicalize();
    return result;
}

// Orthogonal projection of the plane along the axis nearest to the normal, seen from above. The
// projection never degenerates.
class Projection {
public:
    Projection(const Plane& plane, const LoopPoints& points) : points_(points) {
        const std::int32_t x = std::abs(plane.nx);
        const std::int32_t y = std::abs(plane.ny);
        const std::int32_t z = std::abs(plane.nz);
        const int axis = z >= x && z >= y ? 2 : y >= x ? 1 : 0;
        s_ = (axis + 1) % 3;
        t_ = (axis + 2) % 3;
        const std::int32_t along = axis == 0 ? plane.nx : axis == 1 ? plane.ny : plane.nz;
        if (along < 0) std::swap(s_, t_);
    }
    Vec2 approx(std::uint32_t point) const {
        const Vec3 p = points_.approx(point);
        return {p[s_], p[t_]};
    }
    ExactFlat exact(std::uint32_t point) const {
        const ExactPoint p = points_.exact(point);
        const auto coordinate = [&](int axis) {
            return quotient(axis == 0 ? p.x : axis == 1 ? p.y : p.z, p.w);
        };
        return {coordinate(s_), coordinate(t_)};
    }

private:
    const LoopPoints& points_;
    int s_ = 0, t_ = 1;
};

int sign(const mpq_class& v) {
    return sgn(v);
}

}  // namespace

int orientation(std::span<const std::uint32_t> loop, const Plane& plane, const LoopPoints& points) {
    const Projection projection(plane, points);
    const Vec2 o = projection.approx(loop[0]);
    double doubled = 0.0;
    double error = 0.0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        const Vec2 a = projection.approx(loop[i]);
        const Vec2 b = projection.approx(loop[i + 1]);
        doubled += cross(a - o, b - o);
        // Each difference has two coordinate errors; products round far less.
        error += 4.0 * kLoopPointError *
                 (std::abs(a.x - o.x) + std::abs(b.y - o.y) + std::abs(a.y - o.y) +
                  std::abs(b.x - o.x) + 1.0);
    }
    if (doubled > error) return 1;
    if (doubled < -error) return -1;
    const ExactFlat p = projection.exact(loop[0]);
    mpq_class sum = 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        const ExactFlat a = projection.exact(loop[i]);
        const ExactFlat b = projection.exact(loop[i + 1]);
        sum += (a.s - p.s) * (b.t - p.t) - (a.t - p.t) * (b.s - p.s);
    }
    return sign(sum);
}

// Counts crossings of the ray from the point in direction s.
bool surrounds(std::span<const std::uint32_t> loop, std::uint32_t tail, std::uint32_t head,
               const Plane& plane, const LoopPoints& points) {
    const Projection projection(plane, points);
    const Vec2 from = projection.approx(tail);
    const Vec2 to = projection.approx(head);
    const Vec2 p = 0.5 * (from + to);
    std::optional<ExactFlat> exact_p;
    const auto exactly = [&]() -> const ExactFlat& {
        if (!exact_p) {
            const ExactFlat a = projection.exact(tail);
            const ExactFlat b = projection.exact(head);
            exact_p = ExactFlat{(a.s + b.s) / 2, (a.t + b.t) / 2};
        }
        return *exact_p;
    };
    constexpr double kError = 4.0 * kLoopPointError;
    const auto is_above = [&](std::uint32_t point, const Vec2& at) {
        if (std::abs(at.y - p.y) > kError) return at.y > p.y;
        return sign(projection.exact(point).t - exactly().t) > 0;
    };
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t tail_of_edge = loop[i];
        const std::uint32_t head_of_edge = loop[(i + 1) % loop.size()];
        const Vec2 a = projection.approx(tail_of_edge);
        const Vec2 b = projection.approx(head_of_edge);
        const bool upwards = is_above(head_of_edge, b);
        if (is_above(tail_of_edge, a) == upwards) continue;
        // Positive: the point is to the left of the edge.
        const double left = cross(b - a, p - a);
        const double error = kError * (std::abs(b.x - a.x) + std::abs(p.y - a.y) +
                                       std::abs(b.y - a.y) + std::abs(p.x - a.x) + 1.0);
        bool is_left = left > 0.0;
        if (std::abs(left) <= error) {
            const ExactFlat ea = projection.exact(tail_of_edge);
            const ExactFlat eb = projection.exact(head_of_edge);
            const ExactFlat& ep = exactly();
            is_left = sign((eb.s - ea.s) * (ep.t - ea.t) - (eb.t - ea.t) * (ep.s - ea.s)) > 0;
        }
        if (is_left == upwards) inside = !inside;
    }
    return inside;
}

}  // namespace ncsim::cda
