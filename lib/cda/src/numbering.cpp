// SPDX-License-Identifier: GPL-3.0-or-later
#include "numbering.h"

#include "wide.h"

#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace ncsim::cda {

namespace {

std::uint64_t mix(std::uint64_t h, std::uint64_t v) {
    h = (h ^ v) + 0x9e3779b97f4a7c15ULL;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ULL;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebULL;
    return h ^ (h >> 31);
}

std::uint64_t mix(std::uint64_t h, Int128 v) {
    return mix(mix(h, static_cast<std::uint64_t>(v)), static_cast<std::uint64_t>(v >> 64));
}

// Sign of p/q − r/s for q, s > 0, by continued fractions: no product exceeds 128 bits.
int compare_fractions(Int128 p, Int128 q, Int128 r, Int128 s) {
    int sign = 1;
    while (true) {
        const Int128 a = floor_quotient(p, q);
        const Int128 b = floor_quotient(r, s);
        if (a != b) return a < b ? -sign : sign;
        p -= a * q;
        r -= b * s;
        if (p == 0 || r == 0) return sign * (p == r ? 0 : p == 0 ? -1 : 1);
        // Fractions in (0, 1): compare the reciprocals the other way round.
        std::swap(p, q);
        std::swap(r, s);
        sign = -sign;
    }
}

}  // namespace

std::size_t PointNumbers::Hash::operator()(const ExactPoint& p) const noexcept {
    return mix(mix(mix(mix(0, p.x), p.y), p.z), p.w);
}

std::uint32_t PointNumbers::number(const ExactPoint& point) {
    const ExactPoint key = reduced(point);
    const auto [it, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back(key);
    return it->second;
}

std::size_t LineKeyHash::operator()(const LineKey& k) const noexcept {
    std::uint64_t h = 0;
    for (const std::int64_t v : {k.dx, k.dy, k.dz, k.scale}) {
        h = mix(h, static_cast<std::uint64_t>(v));
    }
    return mix(mix(mix(h, k.mx), k.my), k.mz);
}

LineKey line_through(const Plane& s, const Plane& t) {
    // n_s × n_t and d_s n_t − d_t n_s: 50 and 76 bits.
    std::array<Int128, 6> v{
        std::int64_t{s.ny} * t.nz - std::int64_t{s.nz} * t.ny,
        std::int64_t{s.nz} * t.nx - std::int64_t{s.nx} * t.nz,
        std::int64_t{s.nx} * t.ny - std::int64_t{s.ny} * t.nx,
        static_cast<Int128>(s.d) * t.nx - static_cast<Int128>(t.d) * s.nx,
        static_cast<Int128>(s.d) * t.ny - static_cast<Int128>(t.d) * s.ny,
        static_cast<Int128>(s.d) * t.nz - static_cast<Int128>(t.d) * s.nz,
    };
    UInt128 g = 0;
    for (const Int128 c : v)
        g = gcd(g, magnitude(c));
    const bool flip = v[0] != 0 ? v[0] < 0 : v[1] != 0 ? v[1] < 0 : v[2] < 0;
    const Int128 divisor = flip ? -static_cast<Int128>(g) : static_cast<Int128>(g);
    for (Int128& c : v)
        c /= divisor;
    LineKey key;
    const auto dx = static_cast<std::int64_t>(v[0]);
    const auto dy = static_cast<std::int64_t>(v[1]);
    const auto dz = static_cast<std::int64_t>(v[2]);
    key.scale = std::gcd(std::gcd(dx, dy), dz);
    key.dx = dx / key.scale;
    key.dy = dy / key.scale;
    key.dz = dz / key.scale;
    key.mx = v[3];
    key.my = v[4];
    key.mz = v[5];
    return key;
}

int compare_coordinate(const ExactPoint& a, const ExactPoint& b, int axis) {
    const double p = a.approx[axis];
    const double q = b.approx[axis];
    // Each within 2 ulp.
    if (std::abs(p - q) > 1e-15 * (std::abs(p) + std::abs(q))) return p < q ? -1 : 1;
    const auto numerator = [axis](const ExactPoint& v) {
        return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
    };
    return compare_fractions(numerator(a), a.w, numerator(b), b.w);
}

DisjointSets::DisjointSets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0U);
}

std::uint32_t DisjointSets::find(std::uint32_t i) {
    while (parent_[i] != i)
        i = parent_[i] = parent_[parent_[i]];
    return i;
}

void DisjointSets::unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
}

}  // namespace ncsim::cda
