// SPDX-License-Identifier: GPL-3.0-or-later
//
// Storage of outlines, cancellation of pieces, and points in fixed point.
#include "surface/outlines.h"

#include "exact/none.h"
#include "exact/wide.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

namespace ncsim::cda {

namespace {

// Converts to double within a few units in the last place.
double nearly(Int128 v) {
    const UInt128 m = magnitude(v);
    const double size = static_cast<double>(static_cast<std::uint64_t>(m >> 64)) * 0x1p64 +
                        static_cast<double>(static_cast<std::uint64_t>(m));
    return v < 0 ? -size : size;
}

}  // namespace

FixedPoint FixedPoint::of(const ExactPoint& p) {
    // w has 3N + 2.6 bits (predicates.cpp), coordinates are at most w times 2^26, and the shift
    // adds 24 bits.
    static_assert(3 * kNormalBits + 2.6 + kCoordinateBits + 1 + 24 < 127.0);
    const double reciprocal = kScale / nearly(p.w);
    const auto rounded_down = [&](Int128 v) {
        // Quotients have 50 bits and a sign, so doubles are off by at most one or two.
        auto quotient = static_cast<std::int64_t>(nearly(v) * reciprocal);
        Int128 rest = v * (Int128{1} << 24) - quotient * p.w;
        for (; rest < 0; rest += p.w)
            --quotient;
        for (; rest >= p.w; rest -= p.w)
            ++quotient;
        return quotient;
    };
    return {{rounded_down(p.x), rounded_down(p.y), rounded_down(p.z)}};
}

std::optional<std::int64_t> FixedPoint::wall(const std::vector<std::int64_t>& walls,
                                             std::size_t axis) const {
    constexpr std::int64_t kHalfUnit = std::int64_t{1} << 23;
    if (at[axis] % kHalfUnit != 0) return std::nullopt;
    const std::int64_t half = at[axis] / kHalfUnit;
    if (!std::ranges::binary_search(walls, half)) return std::nullopt;
    return half;
}

std::uint32_t Outlines::point(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a > b) std::swap(a, b);
    if (b > c) std::swap(b, c);
    if (a > b) std::swap(a, b);
    const std::array<std::uint32_t, 3> planes{a, b, c};
    if (2 * (points_.size() - page_begin_) >= slots_.size()) grow();
    std::size_t at = hash(planes) & (slots_.size() - 1);
    for (; slots_[at].page == page_; at = (at + 1) & (slots_.size() - 1)) {
        if (points_[slots_[at].point].planes == planes) return slots_[at].point;
    }
    const auto number = static_cast<std::uint32_t>(points_.size());
    const auto exact = meet_exactly(planes_[a], planes_[b], planes_[c]);
    assert(exact);
    points_.push_back({FixedPoint::of(*exact), planes});
    slots_[at] = {page_, number};
    return number;
}

void Outlines::start_page() {
    page_begin_ = points_.size();
    ++page_;
}

void Outlines::grow() {
    slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), {});
    for (std::size_t i = page_begin_; i < points_.size(); ++i) {
        std::size_t at = hash(points_[i].planes) & (slots_.size() - 1);
        while (slots_[at].page == page_)
            at = (at + 1) & (slots_.size() - 1);
        slots_[at] = {page_, static_cast<std::uint32_t>(i)};
    }
}

void Outlines::cancel(std::span<const std::uint32_t> pieces) {
    std::vector<std::uint32_t> open(std::bit_ceil(2 * pieces.size() + 2), kNone);
    std::vector<bool> is_gone(pieces_.size(), false);
    const auto planes_at = [&](std::uint32_t p) -> const auto& {
        return points_[p].planes;
    };
    for (const std::uint32_t number : pieces) {
        const Piece& piece = pieces_[number];
        // Symmetric in tail and head.
        const std::uint64_t ends = hash(planes_at(piece.tail)) + hash(planes_at(piece.head));
        std::size_t at = mix(mix(piece.plane | std::uint64_t{piece.edge} << 32, ends),
                             static_cast<std::uint32_t>(piece.origin)) &
                         (open.size() - 1);
        for (; open[at] != kNone; at = (at + 1) & (open.size() - 1)) {
            const Piece& other = pieces_[open[at]];
            if (is_gone[open[at]] || other.plane != piece.plane || other.edge != piece.edge ||
                other.origin != piece.origin || planes_at(other.tail) != planes_at(piece.head) ||
                planes_at(other.head) != planes_at(piece.tail)) {
                continue;
            }
            is_gone[open[at]] = is_gone[number] = true;
            break;
        }
        if (!is_gone[number]) open[at] = number;
    }
    std::vector<std::uint32_t> moved(points_.size(), kNone);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (is_gone[i]) continue;
        pieces_[kept] = pieces_[i];
        moved[pieces_[kept].tail] = moved[pieces_[kept].head] = 0;
        ++kept;
    }
    pieces_.resize(kept);
    std::uint32_t points = 0;
    for (std::size_t p = 0; p < points_.size(); ++p) {
        if (moved[p] == kNone) continue;
        points_[points] = points_[p];
        moved[p] = points++;
    }
    points_.resize(points);
    for (Piece& piece : pieces_) {
        piece.tail = moved[piece.tail];
        piece.head = moved[piece.head];
    }
    start_page();
}

Outlines Outlines::at(const Walls& walls) const {
    std::vector<bool> is_at(points_.size());
    for (std::size_t p = 0; p < points_.size(); ++p) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (points_[p].fixed.wall(walls[axis], axis)) is_at[p] = true;
        }
    }
    Outlines result;
    std::vector<std::uint32_t> plane_of(planes_.size(), kNone), point_of(points_.size(), kNone);
    const auto plane = [&](std::uint32_t number) {
        if (plane_of[number] == kNone) plane_of[number] = result.add_plane(planes_[number]);
        return plane_of[number];
    };
    const auto point = [&](std::uint32_t number) {
        if (point_of[number] != kNone) return point_of[number];
        Point moved = points_[number];
        for (std::uint32_t& p : moved.planes)
            p = plane(p);
        std::ranges::sort(moved.planes);
        point_of[number] = static_cast<std::uint32_t>(result.points_.size());
        result.add_point(moved);
        return point_of[number];
    };
    for (const Piece& piece : pieces_) {
        if (!is_at[piece.tail] && !is_at[piece.head]) continue;
        result.add({2 * plane(piece.plane / 2) | (piece.plane & 1), plane(piece.edge), piece.origin,
                    point(piece.tail), point(piece.head)});
    }
    result.close();
    return result;
}

void Outlines::close() {
    slots_ = {};
    points_.shrink_to_fit();
    pieces_.shrink_to_fit();
}

}  // namespace ncsim::cda
