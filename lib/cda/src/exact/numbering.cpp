// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plücker coordinates: hash and comparison.
#include "exact/numbering.h"

#include "ncsim/base/mix.h"

namespace ncsim::cda {

Pluecker::Pluecker(const Plane& s, const Plane& t)
    : d{std::int64_t{s.ny} * t.nz - std::int64_t{s.nz} * t.ny,
        std::int64_t{s.nz} * t.nx - std::int64_t{s.nx} * t.nz,
        std::int64_t{s.nx} * t.ny - std::int64_t{s.ny} * t.nx},
      m{static_cast<Int128>(s.d) * t.nx - static_cast<Int128>(t.d) * s.nx,
        static_cast<Int128>(s.d) * t.ny - static_cast<Int128>(t.d) * s.ny,
        static_cast<Int128>(s.d) * t.nz - static_cast<Int128>(t.d) * s.nz} {
    if (d[0] != 0 ? d[0] > 0 : d[1] != 0 ? d[1] > 0 : d[2] > 0) return;
    for (std::size_t i = 0; i < 3; ++i) {
        d[i] = -d[i];
        m[i] = -m[i];
    }
}

std::uint64_t Pluecker::hash() const {
    // Quotients by the longest component of the direction are independent of the common factor.
    // Integers, rounded towards zero.
    const std::size_t axis = longest(d);
    const Int128 divisor = d[axis];
    std::uint64_t h = axis;
    for (std::size_t i = 0; i < 3; ++i) {
        if (i == axis) continue;
        h = mix(h, static_cast<std::uint64_t>((static_cast<Int128>(d[i]) << 30) / divisor));
        h = mix(h, static_cast<std::uint64_t>((m[i] * (1 << 10)) / divisor));
    }
    return h;
}

bool are_same(const Pluecker& a, const Pluecker& b) {
    // Tests that each pair of coordinates is proportional; directions are non-zero and agree in
    // sign.
    const std::size_t axis = longest(a.d);
    const Int128 p = a.d[axis];
    const Int128 q = b.d[axis];
    for (std::size_t i = 0; i < 3; ++i) {
        if (p * b.d[i] != q * a.d[i]) return false;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        // 50 and 78 bits: compares quotient and remainder, so that no product overflows.
        if (a.m[i] / p != b.m[i] / q) return false;
        if ((a.m[i] % p) * q != (b.m[i] % q) * p) return false;
    }
    return true;
}

}  // namespace ncsim::cda
