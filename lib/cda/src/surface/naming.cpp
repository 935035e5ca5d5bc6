// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 1 of stitching, see naming.h.
#include "surface/naming.h"

#include "ncsim/base/parallel.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace ncsim::cda {

namespace {

bool is_flipped(const Plane& plane) {
    return plane.nx != 0 ? plane.nx < 0 : plane.ny != 0 ? plane.ny < 0 : plane.nz < 0;
}

}  // namespace

bool Naming::SamePoint::operator()(const PointKey& a, const PointKey& b) const {
    if (a.fixed != b.fixed) return false;
    if (a.planes == b.planes) return true;
    const ExactPoint p = exact(b, *planes);
    return std::all_of(a.planes.begin(), a.planes.end(), [&](std::uint32_t plane) {
        return classify_exact(p, (*planes)[plane]) == Side::On;
    });
}

Plane Naming::plane_of(PlaneRef ref) const {
    const Plane& plane = planes_.keys()[ref / 2];
    return ref & 1 ? plane.opposite() : plane;
}

void Naming::add_part(const Outlines& part) {
    add_part(part, false);
}

void Naming::add_outside(const Outlines& part) {
    has_outside_ = true;
    add_part(part, true);
}

std::array<Plane, 3> Naming::planes_at(std::uint32_t p) const {
    const PointKey& key = points_.keys()[p];
    return {planes_.keys()[key.planes[0]], planes_.keys()[key.planes[1]],
            planes_.keys()[key.planes[2]]};
}

void Naming::add_part(const Outlines& part, bool is_outside) {
    plane_keys_.clear();
    for (const Plane& plane : part.planes())
        plane_keys_.push_back(is_flipped(plane) ? plane.opposite() : plane);
    plane_refs_.resize(plane_keys_.size());
    planes_.number_all(plane_keys_, [&](std::size_t i, std::uint32_t n) {
        plane_refs_[i] = 2 * n + static_cast<PlaneRef>(is_flipped(part.planes()[i]));
    });
    point_keys_.clear();
    for (const Outlines::Point& point : part.points()) {
        PointKey key{point.fixed, {}};
        for (std::size_t i = 0; i < 3; ++i)
            key.planes[i] = plane_refs_[point.planes[i]] / 2;
        std::sort(key.planes.begin(), key.planes.end());
        point_keys_.push_back(key);
    }
    point_numbers_.resize(point_keys_.size());
    points_.number_all(point_keys_, [&](std::size_t i, std::uint32_t n) { point_numbers_[i] = n; });

    // A part has few pairs of planes compared with pieces, so a small table of pairs saves most
    // computations of lines. Pieces of one facet are consecutive.
    Interner<std::array<std::uint32_t, 2>, PairHash> pairs;
    line_keys_.clear();
    line_directions_.clear();
    owner_keys_.clear();
    std::vector<NumberedPiece>& named = named_.emplace_back();
    named.reserve(part.pieces().size());
    for (const Outlines::Piece& piece : part.pieces()) {
        const std::uint32_t tail = point_numbers_[piece.tail];
        const std::uint32_t head = point_numbers_[piece.head];
        if (tail == head) continue;
        const PlaneRef plane = plane_refs_[piece.plane / 2] ^ (piece.plane & 1);
        const std::uint32_t edge = plane_refs_[piece.edge] / 2;
        const std::array<std::uint32_t, 2> pair{std::min(plane / 2, edge),
                                                std::max(plane / 2, edge)};
        const std::uint32_t p = pairs(pair);
        if (p == line_keys_.size()) {
            const Pluecker line(planes_.keys()[pair[0]], planes_.keys()[pair[1]]);
            line_keys_.push_back({pair, line.hash()});
            line_directions_.push_back({line.d[0], line.d[1], line.d[2]});
        }
        const Owner owner{plane, is_outside ? kOutside : piece.origin};
        if (owner_keys_.empty() || owner != owner_keys_.back()) owner_keys_.push_back(owner);
        const auto last = static_cast<std::uint32_t>(owner_keys_.size() - 1);
        named.push_back({p, tail, head, last & kMostOwners, true});
    }
    line_numbers_.resize(line_keys_.size());
    lines_.number_all(line_keys_, [&](std::size_t i, std::uint32_t n) {
        line_numbers_[i] = n;
        if (n == directions_.size()) directions_.push_back(line_directions_[i]);
    });
    part_owners_.resize(owner_keys_.size());
    owner_numbers_.number_all(owner_keys_,
                              [&](std::size_t i, std::uint32_t n) { part_owners_[i] = n; });
    for (NumberedPiece& n : named) {
        n.line = line_numbers_[n.line];
        n.owner = part_owners_[n.owner] & kMostOwners;
    }
}

Groups<Interval> Naming::finish(std::size_t threads) {
    if (owner_numbers_.size() > kMostOwners || lines() > kMostLines)
        throw std::length_error("the surface of the part has too many faces");
    lines_ = Interner<LineKey, HashLine, SameLine>({}, SameLine{&planes_.keys()});
    points_.close();
    planes_.close();
    std::vector<std::uint32_t> order(owner_numbers_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::vector<std::pair<Plane, Origin>> values;
    values.reserve(order.size());
    for (std::size_t i = 0; i < owner_numbers_.size(); ++i) {
        const Owner& owner = owner_numbers_.keys()[i];
        values.emplace_back(plane_of(owner.plane), owner.origin);
    }
    owner_numbers_ = Interner<Owner, HashOwner>();
    sort_in_parallel(threads, order,
                     [&](std::uint32_t a, std::uint32_t b) { return values[a] < values[b]; });
    std::vector<std::uint32_t> rank(order.size());
    owners_.reserve(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        rank[order[i]] = i;
        owners_.push_back(values[order[i]]);
    }
    in_parallel(threads, named_.size(), [&](std::size_t i) {
        for (NumberedPiece& n : named_[i]) {
            n.forward = comes_before(n.line, n.tail, n.head);
            if (!n.forward) std::swap(n.tail, n.head);
            n.owner = rank[n.owner] & kMostOwners;
        }
    });
    Groups<Interval> intervals(lines());
    for (const std::vector<NumberedPiece>& part : named_) {
        for (const NumberedPiece& n : part)
            intervals.count(n.line);
    }
    intervals.reserve();
    for (std::vector<NumberedPiece>& part : named_) {
        for (const NumberedPiece& n : part)
            intervals.add(n.line, {n.tail, n.head, n.owner, n.forward});
        part = {};
    }
    return intervals;
}

int Naming::compare(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return 0;
    const PointKey& p = points_.keys()[a];
    const PointKey& q = points_.keys()[b];
    if (p.fixed != q.fixed) return p.fixed.at < q.fixed.at ? -1 : 1;
    const ExactPoint v = exact(a);
    const ExactPoint w = exact(b);
    for (int axis = 0; axis < 3; ++axis) {
        if (const int order = compare_coordinate(v, w, axis)) return order;
    }
    return 0;
}

// Compares along the axis in which the direction is longest, because coordinates differ most there.
bool Naming::comes_before(std::uint32_t line, std::uint32_t a, std::uint32_t b) const {
    const Direction& d = directions_[line];
    const std::array<std::int64_t, 3> c{d.x, d.y, d.z};
    const std::size_t axis = longest(c);
    const std::int64_t p = points_.keys()[a].fixed.at[axis];
    const std::int64_t q = points_.keys()[b].fixed.at[axis];
    int order = p < q ? -1 : 1;
    if (p == q) {
        if (a == b) return false;
        order = compare_coordinate(exact(a), exact(b), static_cast<int>(axis));
    }
    return c[axis] > 0 ? order < 0 : order > 0;
}

}  // namespace ncsim::cda
