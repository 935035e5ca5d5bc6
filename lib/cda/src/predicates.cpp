// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bits, for normals of N and coordinates of B bits: a plane that meets the stock has
// |d| <= 3·2^(N+B); a vertex has w of 3N + log2 6 and coordinates of |d|·2^2N·6 … but Hadamard-like
// cancellation keeps them at w·2^B, since the point lies within the stock; n·x − d·w adds
// N + log2 3 to the one and |d| to the other.
#include "ncsim/cda/predicates.h"

#include "wide.h"

#include <cmath>

namespace ncsim::cda {

namespace {

// Twice the bits, rounded up, of the largest sum in classify_exact: w has 3N + 2.6 bits, a
// coordinate of the point w·2^B, and there are three products of N more bits and d·w of 1.6 more
// again.
constexpr double kClassifyBits = 4.0 * kNormalBits + kCoordinateBits + 2.6 + 1.6 + 1.0;
static_assert(kClassifyBits < 127.0, "a sign needs more than 128 bits");

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

// The cross product of two normals.
struct Minor {
    std::int64_t x, y, z;
};

Minor minor(const Plane& a, const Plane& b) {
    return {std::int64_t{a.ny} * b.nz - std::int64_t{a.nz} * b.ny,
            std::int64_t{a.nz} * b.nx - std::int64_t{a.nx} * b.nz,
            std::int64_t{a.nx} * b.ny - std::int64_t{a.ny} * b.nx};
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
    // Below 2^50, but for a bit.
    const Minor qr = minor(q, r);
    const Minor rp = minor(r, p);
    const Minor pq = minor(p, q);
    const auto size = [](std::int64_t a, std::int32_t b) {
        return std::abs(static_cast<double>(a) * static_cast<double>(b));
    };
    const double w_at_most = size(qr.x, p.nx) + size(qr.y, p.ny) + size(qr.z, p.nz);
    constexpr double kFits = 0x1p62;
    if (w_at_most * most >= kFits) return classify_exact(*meet_exactly(p, q, r), plane);
    // Sums and products that wrap around; the last one does not.
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
    // What is common to all terms may be negative.
    const Int128 exact_w = static_cast<Int128>(qr.x) * p.nx + static_cast<Int128>(qr.y) * p.ny +
                           static_cast<Int128>(qr.z) * p.nz;
    return (height > 0) == (exact_w > 0) ? Side::Above : Side::Below;
}

Side classify(const ExactPoint& p, const Plane& plane) {
    const double v = p.approx.x * plane.nx + p.approx.y * plane.ny + p.approx.z * plane.nz -
                     static_cast<double>(plane.d);
    if (v > kFilterError) return Side::Above;
    if (v < -kFilterError) return Side::Below;
    return classify_exact(p, plane);
}

ExactPoint reduced(const ExactPoint& p) {
    const UInt128 g = gcd(gcd(magnitude(p.x), magnitude(p.y)), gcd(magnitude(p.z), magnitude(p.w)));
    const auto s = static_cast<Int128>(g);
    ExactPoint r{p.x / s, p.y / s, p.z / s, p.w / s, {}};
    // From the reduced numbers, so that the doubles too depend on the point alone.
    r.approx = nearest(r);
    return r;
}

bool same_point(const ExactPoint& a, const ExactPoint& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
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

}  // namespace ncsim::cda
