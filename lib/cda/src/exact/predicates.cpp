// SPDX-License-Identifier: GPL-3.0-or-later
//
// The predicates: filters in doubles, decisions in 128-bit integers.
#include "ncsim/cda/predicates.h"

#include "exact/filter_counts.h"
#include "exact/wide.h"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace ncsim::cda {

namespace {

// Largest error of the double evaluation n·approx − d, in plane units: coordinates below 2^B within
// 2 ulp times normals below 2^N, three products, three sums: below 16 · 2^(N+B) · 2^-53.
constexpr double kFilterError = 16.0 * static_cast<double>(std::int64_t{1} << kNormalBits) *
                                static_cast<double>(std::int64_t{1} << kCoordinateBits) /
                                9007199254740992.0;

constexpr Int128 det2(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return static_cast<Int128>(a) * d - static_cast<Int128>(b) * c;
}

Side side_of(Int128 v) {
    return v > 0 ? Side::Above : v < 0 ? Side::Below : Side::On;
}

// Cross product of two normals.
struct Minor {
    std::int64_t x, y, z;
};

Minor minor(const Plane& a, const Plane& b) {
    return {std::int64_t{a.ny} * b.nz - std::int64_t{a.nz} * b.ny,
            std::int64_t{a.nz} * b.nx - std::int64_t{a.nx} * b.nz,
            std::int64_t{a.nx} * b.ny - std::int64_t{a.ny} * b.nx};
}

// Returns the sign of p/q − r/s for q, s > 0, by continued fractions: no product exceeds 128 bits.
int compare_fractions(Int128 p, Int128 q, Int128 r, Int128 s) {
    int sign = 1;
    while (true) {
        const Int128 a = floor_quotient(p, q);
        const Int128 b = floor_quotient(r, s);
        if (a != b) return a < b ? -sign : sign;
        p -= a * q;
        r -= b * s;
        if (p == 0 || r == 0) return sign * (p == r ? 0 : p == 0 ? -1 : 1);
        // Both fractions are in (0, 1): compares the reciprocals with opposite sign.
        std::swap(p, q);
        std::swap(r, s);
        sign = -sign;
    }
}

Vec3 nearest(const ExactPoint& p) {
    const auto w = static_cast<double>(p.w);
    return {static_cast<double>(p.x) / w, static_cast<double>(p.y) / w,
            static_cast<double>(p.z) / w};
}

}  // namespace

ExactPoint ExactPoint::at(LatticePoint p) {
    return {p.x,
            p.y,
            p.z,
            1,
            {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)}};
}

std::optional<ExactPoint> meet_exactly(const Plane& p, const Plane& q, const Plane& r) {
    // Cramer's rule, expanded along the column of distances: x = Σ d_i (n_j × n_k).
    const Minor qr = minor(q, r);
    const Minor rp = minor(r, p);
    const Minor pq = minor(p, q);
    const Int128 w = static_cast<Int128>(qr.x) * p.nx + static_cast<Int128>(qr.y) * p.ny +
                     static_cast<Int128>(qr.z) * p.nz;
    if (w == 0) return std::nullopt;
    const auto sum = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
        return static_cast<Int128>(p.d) * a + static_cast<Int128>(q.d) * b +
               static_cast<Int128>(r.d) * c;
    };
    ExactPoint v{sum(qr.x, rp.x, pq.x), sum(qr.y, rp.y, pq.y), sum(qr.z, rp.z, pq.z), w, {}};
    if (w < 0) v.x = -v.x, v.y = -v.y, v.z = -v.z, v.w = -v.w;
    return v;
}

std::optional<ExactPoint> meet(const Plane& p, const Plane& q, const Plane& r) {
    auto point = meet_exactly(p, q, r);
    if (point) point->approx = nearest(*point);
    return point;
}

Side classify_exact(const ExactPoint& p, const Plane& plane) {
    return side_of(p.x * plane.nx + p.y * plane.ny + p.z * plane.nz - p.w * plane.d);
}

Side classify_near(const Plane& p, const Plane& q, const Plane& r, const Plane& plane,
                   double most) {
    // Cross products are below 2^50, up to one bit.
    const Minor qr = minor(q, r);
    const Minor rp = minor(r, p);
    const Minor pq = minor(p, q);
    const auto size = [](std::int64_t a, std::int32_t b) {
        return std::abs(static_cast<double>(a) * static_cast<double>(b));
    };
    const double w_at_most = size(qr.x, p.nx) + size(qr.y, p.ny) + size(qr.z, p.nz);
    constexpr double kFits = 0x1p62;
    if (w_at_most * most >= kFits) return classify_exact(*meet_exactly(p, q, r), plane);
    // Sums and products modulo 2^64; the final value fits 64 bits.
    const auto times = [](std::int64_t a, std::int64_t b) {
        return static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b);
    };
    const auto sum = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
        return times(p.d, a) + times(q.d, b) + times(r.d, c);
    };
    const std::uint64_t w = times(qr.x, p.nx) + times(qr.y, p.ny) + times(qr.z, p.nz);
    const auto height = static_cast<std::int64_t>(
        sum(qr.x, rp.x, pq.x) * static_cast<std::uint64_t>(std::int64_t{plane.nx}) +
        sum(qr.y, rp.y, pq.y) * static_cast<std::uint64_t>(std::int64_t{plane.ny}) +
        sum(qr.z, rp.z, pq.z) * static_cast<std::uint64_t>(std::int64_t{plane.nz}) -
        w * static_cast<std::uint64_t>(plane.d));
    if (height == 0) return Side::On;
    // The common factor w may be negative.
    const Int128 exact_w = static_cast<Int128>(qr.x) * p.nx + static_cast<Int128>(qr.y) * p.ny +
                           static_cast<Int128>(qr.z) * p.nz;
    return (height > 0) == (exact_w > 0) ? Side::Above : Side::Below;
}

std::optional<Side> classify_in_doubles(const ExactPoint& p, const Plane& plane) {
    const double v = p.approx.x * plane.nx + p.approx.y * plane.ny + p.approx.z * plane.nz -
                     static_cast<double>(plane.d);
    if (v > kFilterError) return Side::Above;
    if (v < -kFilterError) return Side::Below;
    return std::nullopt;
}

Side classify(const ExactPoint& p, const Plane& plane) {
    count_query(Filter::Point);
    if (const auto side = classify_in_doubles(p, plane)) return *side;
    count_doubtful(Filter::Point);
    const Side side = classify_exact(p, plane);
    if (side == Side::On) count_touching(Filter::Point);
    return side;
}

ExactPoint reduced(const ExactPoint& p) {
    const UInt128 g = gcd(gcd(magnitude(p.x), magnitude(p.y)), gcd(magnitude(p.z), magnitude(p.w)));
    const auto s = static_cast<Int128>(g);
    ExactPoint r{p.x / s, p.y / s, p.z / s, p.w / s, {}};
    // Computed from the reduced numbers, so that the doubles depend only on the point.
    r.approx = nearest(r);
    return r;
}

bool same_point(const ExactPoint& a, const ExactPoint& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
}

int compare_coordinate_exact(const ExactPoint& a, const ExactPoint& b, int axis) {
    const auto numerator = [axis](const ExactPoint& v) {
        return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
    };
    return compare_fractions(numerator(a), a.w, numerator(b), b.w);
}

int compare_coordinate(const ExactPoint& a, const ExactPoint& b, int axis) {
    const double p = a.approx[axis];
    const double q = b.approx[axis];
    count_query(Filter::Coordinate);
    // Both coordinates are within 2 ulp.
    if (std::abs(p - q) > 1e-15 * (std::abs(p) + std::abs(q))) return p < q ? -1 : 1;
    count_doubtful(Filter::Coordinate);
    const int order = compare_coordinate_exact(a, b, axis);
    if (order == 0) count_touching(Filter::Coordinate);
    return order;
}

int turn(const Plane& s, const Plane& t, const Plane& h) {
    const Int128 v = static_cast<Int128>(det2(s.ny, s.nz, t.ny, t.nz)) * h.nx +
                     static_cast<Int128>(det2(s.nz, s.nx, t.nz, t.nx)) * h.ny +
                     static_cast<Int128>(det2(s.nx, s.ny, t.nx, t.ny)) * h.nz;
    return v > 0 ? 1 : v < 0 ? -1 : 0;
}

Side order_along(const Plane& s, const Plane& t, const ExactPoint& a, const Plane& through_b) {
    const Side side = classify(a, through_b);
    return turn(s, t, through_b) > 0 ? side : opposite(side);
}

int compare_distances(const Plane& a, const Plane& b) {
    // Compares d/|n| by a non-zero component: normals of parallel planes are proportional.
    const auto component = [axis = a.nx != 0   ? 0
                                   : a.ny != 0 ? 1
                                               : 2](const Plane& p) {
        return static_cast<Int128>(std::abs(axis == 0 ? p.nx : axis == 1 ? p.ny : p.nz));
    };
    const Int128 difference = b.d * component(a) - a.d * component(b);
    return difference > 0 ? 1 : difference < 0 ? -1 : 0;
}

int distance_beyond(const Plane& facet, const Plane& plane, bool same) {
    return compare_distances(facet, same ? plane : plane.opposite()) * (same ? 1 : -1);
}

}  // namespace ncsim::cda
