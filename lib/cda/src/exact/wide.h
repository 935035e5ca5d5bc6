// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operations on 128-bit integers that the compiler does not provide.
#pragma once

#include "ncsim/base/int128.h"

#include <bit>
#include <cstdint>
#include <utility>

namespace ncsim::cda {

__extension__ using UInt128 = unsigned __int128;

inline UInt128 magnitude(Int128 v) {
    return v < 0 ? -static_cast<UInt128>(v) : static_cast<UInt128>(v);
}

inline int trailing_zeros(UInt128 v) {
    const auto low = static_cast<std::uint64_t>(v);
    return low != 0 ? std::countr_zero(low)
                    : 64 + std::countr_zero(static_cast<std::uint64_t>(v >> 64));
}

/// Returns the greatest common divisor by Stein's binary algorithm: shifts and subtractions,
/// because 128-bit division is slow.
inline UInt128 gcd(UInt128 a, UInt128 b) {
    if (a == 0) return b;
    if (b == 0) return a;
    const int shift = trailing_zeros(a | b);
    a >>= trailing_zeros(a);
    while (b != 0) {
        b >>= trailing_zeros(b);
        if (a > b) std::swap(a, b);
        b -= a;
    }
    return a << shift;
}

/// Returns the largest integer not above p / q, q > 0.
inline Int128 floor_quotient(Int128 p, Int128 q) {
    const Int128 quotient = p / q;
    return p % q < 0 ? quotient - 1 : quotient;
}

}  // namespace ncsim::cda
