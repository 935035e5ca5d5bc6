// SPDX-License-Identifier: GPL-3.0-or-later
//
// Box tree of triangles: construction, nearest triangle, ray casting.
#include "ncsim/base/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace ncsim {

namespace {

constexpr std::size_t kLeaf = 4;  // triangles

double distance_to_box(Vec3 p, const Box& box) {
    Vec3 off;
    for (int axis = 0; axis < 3; ++axis)
        off[axis] = std::max({box.min[axis] - p[axis], 0.0, p[axis] - box.max[axis]});
    return norm(off);
}

// Returns +1 or -1 if the ray from `p` leaves or enters through the triangle, 0 if the ray misses;
// empty if rounding decides because the ray is too close to the border or too flat.
// Source: Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
std::optional<int> crossing(Vec3 p, Vec3 direction, const TriangleCorners& t) {
    constexpr double kDoubt = 1e-9;
    const Vec3 e1 = t[1] - t[0];
    const Vec3 e2 = t[2] - t[0];
    const Vec3 h = cross(direction, e2);
    const double a = dot(e1, h);
    const Vec3 s = p - t[0];
    if (std::abs(a) <= kDoubt * norm(e1) * norm(e2)) {
        // The ray is parallel to the triangle; only a ray in the triangle's plane is undecided.
        const Vec3 n = cross(e1, e2);
        if (std::abs(dot(s, n)) > kDoubt * norm(n) * (norm(s) + 1.0)) return 0;
        return norm(n) > 0.0 ? std::nullopt : std::optional(0);
    }
    const double u = dot(s, h) / a;
    const Vec3 q = cross(s, e1);
    const double v = dot(direction, q) / a;
    if (std::min({u, v, 1.0 - u - v}) < -kDoubt) return 0;
    if (dot(e2, q) / a <= 0.0) return 0;
    if (std::min({u, v, 1.0 - u - v}) < kDoubt) return std::nullopt;
    return a > 0.0 ? -1 : 1;
}

std::vector<std::uint32_t> all_of(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    return all;
}

}  // namespace

TriangleCorners corners_of(const TriangleMesh& mesh, std::uint32_t triangle) {
    const auto& t = mesh.triangles[triangle];
    return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
    const Vec3 along = b - a;
    const double length = dot(along, along);
    const double t = length > 0.0 ? std::clamp(dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    return norm(p - a - t * along);
}

double distance(Vec3 p, const TriangleCorners& t) {
    const Vec3 n = normalized(cross(t[1] - t[0], t[2] - t[0]));
    const auto is_left_of = [&](Vec3 from, Vec3 to) {
        return dot(cross(to - from, p - from), n) >= 0.0;
    };
    if (norm(n) > 0.0 && is_left_of(t[0], t[1]) && is_left_of(t[1], t[2]) &&
        is_left_of(t[2], t[0])) {
        return std::abs(dot(n, p - t[0]));
    }
    return std::min({distance_to_segment(p, t[0], t[1]), distance_to_segment(p, t[1], t[2]),
                     distance_to_segment(p, t[2], t[0])});
}

bool meets_segment(const Box& box, Vec3 a, Vec3 b) {
    constexpr double kSlack = 1e-9;  // relative to the compared values: far above rounding
    double first = 0.0, last = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double way = b[axis] - a[axis];
        const double slack = kSlack * (1.0 + std::abs(a[axis]) + std::abs(b[axis]));
        const double low = box.min[axis] - slack - a[axis];
        const double high = box.max[axis] + slack - a[axis];
        if (way == 0.0) {
            if (low > 0.0 || high < 0.0) return false;
            continue;
        }
        first = std::max(first, std::min(low / way, high / way));
        last = std::min(last, std::max(low / way, high / way));
    }
    return first <= last + kSlack;
}

TriangleTree::TriangleTree(const TriangleMesh& mesh) : TriangleTree(mesh, all_of(mesh)) {}

TriangleTree::TriangleTree(const TriangleMesh& mesh, std::vector<std::uint32_t> triangles)
    : mesh_(mesh), order_(std::move(triangles)) {
    if (order_.empty()) return;
    std::vector<Placed> placed;
    placed.reserve(order_.size());
    for (const std::uint32_t t : order_) {
        const TriangleCorners c = corners_of(mesh_, t);
        placed.push_back({(1.0 / 3.0) * (c[0] + c[1] + c[2]), t});
    }
    build(placed, 0, placed.size());
}

std::size_t TriangleTree::build(std::vector<Placed>& placed, std::size_t begin, std::size_t end) {
    const std::size_t number = nodes_.size();
    nodes_.push_back({{}, begin, end});
    if (end - begin <= kLeaf) {
        Box box;
        for (std::size_t i = begin; i < end; ++i) {
            order_[i] = placed[i].triangle;
            for (const Vec3& corner : corners_of(mesh_, order_[i]))
                box.add(corner);
        }
        std::sort(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                  order_.begin() + static_cast<std::ptrdiff_t>(end));
        nodes_[number].box = box;
        return number;
    }
    Box middles;
    for (std::size_t i = begin; i < end; ++i)
        middles.add(placed[i].middle);
    const Vec3 size = middles.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return placed.begin() + static_cast<std::ptrdiff_t>(i); };
    // Ties are ordered by number, so that every standard library gives the same halves.
    std::nth_element(at(begin), at(half), at(end), [&](const Placed& s, const Placed& t) {
        const double a = s.middle[axis], b = t.middle[axis];
        return a < b || (a == b && s.triangle < t.triangle);
    });
    const std::size_t left = build(placed, begin, half);
    const std::size_t right = build(placed, half, end);
    Node& node = nodes_[number];
    node.left = left;
    node.right = right;
    node.box = nodes_[left].box;
    node.box.add(nodes_[right].box);
    return number;
}

void TriangleTree::search(std::size_t number, Vec3 p, Nearest& nearest) const {
    const Node& node = nodes_[number];
    if (node.right == 0) {
        for (std::size_t i = node.begin; i < node.end; ++i) {
            const double d = distance(p, corners_of(mesh_, order_[i]));
            if (d < nearest.distance_mm) nearest = {d, order_[i]};
        }
        return;
    }
    std::size_t first = node.left;
    std::size_t second = node.right;
    double to_first = distance_to_box(p, nodes_[first].box);
    double to_second = distance_to_box(p, nodes_[second].box);
    if (to_second < to_first) {
        std::swap(first, second);
        std::swap(to_first, to_second);
    }
    if (to_first < nearest.distance_mm) search(first, p, nearest);
    if (to_second < nearest.distance_mm) search(second, p, nearest);
}

TriangleTree::Nearest TriangleTree::nearest(Vec3 p) const {
    Nearest result;
    if (!nodes_.empty()) search(0, p, result);
    return result;
}

bool TriangleTree::contains(Vec3 p) const {
    if (nodes_.empty() || !nodes_.front().box.contains(p)) return false;
    const double far = 2.0 * norm(nodes_.front().box.size()) + 1.0;
    // The direction lies in no plane that programs or designs usually contain. If a ray is too
    // close to an edge, a ray in another direction is cast.
    Vec3 direction = normalized({0.5773241, 0.2113249, 0.7886751});
    int winding = 0;
    for (int attempt = 0; attempt < 16; ++attempt) {
        winding = 0;
        bool doubtful = false;
        visit([&](const Box& box) { return meets_segment(box, p, p + far * direction); },
              [&](std::uint32_t t) {
                  const auto sign = crossing(p, direction, corners_of(mesh_, t));
                  doubtful |= !sign;
                  winding += sign.value_or(0);
              });
        if (!doubtful) break;
        direction = normalized(Vec3{direction.y + 0.137, direction.z - 0.291, direction.x + 0.071});
    }
    return winding != 0;
}

}  // namespace ncsim
