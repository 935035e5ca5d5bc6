// SPDX-License-Identifier: GPL-3.0-or-later
//
// Containment of cells by comparison of planes.
#include "polytope/within.h"

#include "ncsim/base/int128.h"
#include "ncsim/cda/polytope.h"

#include <algorithm>
#include <cstddef>

namespace ncsim::cda {

namespace {

bool is_upright(const Plane& p) {
    return p.nz == 0;
}

// Returns the cross product of the normals of upright planes; > 0 if b is to the left of a.
std::int64_t turn(const Plane& a, const Plane& b) {
    return std::int64_t{a.nx} * b.ny - std::int64_t{a.ny} * b.nx;
}

// True if all points below the upright planes a and b, with p between, are below p: p = (turn(p, b)
// a + turn(a, p) b) / turn(a, b).
bool imply(const Plane& a, const Plane& b, const Plane& p) {
    return Int128{turn(p, b)} * a.d + Int128{turn(a, p)} * b.d <= Int128{turn(a, b)} * p.d;
}

// True if the planes of `inner` next to the upright plane p on both sides, less than half a turn
// apart, imply p.
bool is_implied(const Cell& inner, const Plane& p) {
    const Plane *right = nullptr, *left = nullptr;
    for (const Plane& q : inner.planes) {
        if (!is_upright(q)) continue;
        const std::int64_t side = turn(p, q);
        if (side > 0 && (!left || turn(*left, q) < 0)) left = &q;
        if (side < 0 && (!right || turn(*right, q) > 0)) right = &q;
        if (side == 0 && q.nx == p.nx && q.ny == p.ny) return q.d <= p.d;
    }
    return left && right && turn(*right, *left) > 0 && imply(*right, *left, p);
}

}  // namespace

bool lies_within(const Cell& inner, const Cell& outer, const Box& place) {
    // The first planes of hulls of one body have the same normals in the same order.
    const std::size_t shared =
        inner.normals && inner.normals == outer.normals ? inner.normals->size() : 0;
    const auto is_below = [&](std::size_t i) {
        const Plane& p = outer.planes[i];
        if (i < shared) return inner.planes[i].d <= p.d;
        if (is_upright(p)) return is_implied(inner, p);
        return std::any_of(inner.planes.begin() + static_cast<std::ptrdiff_t>(shared),
                           inner.planes.end(), [&](const Plane& q) {
                               return q.nx == p.nx && q.ny == p.ny && q.nz == p.nz && q.d <= p.d;
                           });
    };
    for (std::size_t i = 0; i < outer.planes.size(); ++i) {
        if (!is_below(i) && classify_box(place, outer.planes[i]) != Side::Below) return false;
    }
    return true;
}

}  // namespace ncsim::cda
