// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines.h"

#include <algorithm>
#include <cassert>

namespace ncsim::cda {

FixedPoint FixedPoint::of(const ExactPoint& p) {
    // w has 3N + 2.6 bits (predicates.cpp) and coordinates are w times 2^26 at most: 24 bits more
    // than that.
    static_assert(3 * kNormalBits + 2.6 + kCoordinateBits + 1 + 24 < 127.0);
    const auto rounded_down = [&](Int128 v) {
        const Int128 scaled = v * (Int128{1} << 24);
        const Int128 quotient = scaled / p.w;
        return static_cast<std::int64_t>(quotient * p.w > scaled ? quotient - 1 : quotient);
    };
    return {{rounded_down(p.x), rounded_down(p.y), rounded_down(p.z)}};
}

std::uint32_t Outlines::point(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::array<std::uint32_t, 3> key{a, b, c};
    std::sort(key.begin(), key.end());
    const std::uint32_t number = triples_(key);
    if (number == points_.size()) {
        const auto exact = meet_exactly(planes_[key[0]], planes_[key[1]], planes_[key[2]]);
        assert(exact);
        points_.push_back({FixedPoint::of(*exact), key});
    }
    return number;
}

void Outlines::close() {
    triples_ = decltype(triples_){};
    points_.shrink_to_fit();
    pieces_.shrink_to_fit();
}

}  // namespace ncsim::cda
