// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tree of boxes over the triangles, halved at the median of their middles along the longest side.
#include "deviation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace ncsim::exporter {

namespace {

using cda::Vec3;

constexpr std::size_t kLeaf = 4;  // triangles

double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
    const Vec3 along = b - a;
    const double length = cda::dot(along, along);
    const double t = length > 0.0 ? std::clamp(cda::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    return cda::norm(p - a - t * along);
}

double distance_to_box(Vec3 p, const cda::Box& box) {
    Vec3 off;
    for (int axis = 0; axis < 3; ++axis)
        off[axis] = std::max({box.min[axis] - p[axis], 0.0, p[axis] - box.max[axis]});
    return cda::norm(off);
}

class Tree {
public:
    explicit Tree(const cda::TriangleMesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
        std::iota(order_.begin(), order_.end(), 0U);
        if (!order_.empty()) build(0, order_.size());
    }

    double distance(Vec3 p) const {
        double nearest = cda::Box::kInf;
        if (!nodes_.empty()) search(0, p, nearest);
        return nearest;
    }

private:
    struct Node {
        cda::Box box;
        std::size_t begin = 0, end = 0;   // in order_
        std::size_t left = 0, right = 0;  // nodes; 0: a leaf
    };

    Vec3 corner(std::uint32_t triangle, std::size_t i) const {
        return mesh_.vertices[mesh_.triangles[triangle][i]];
    }
    Vec3 middle(std::uint32_t t) const {
        return (1.0 / 3.0) * (corner(t, 0) + corner(t, 1) + corner(t, 2));
    }

    std::size_t build(std::size_t begin, std::size_t end) {
        const std::size_t number = nodes_.size();
        Node node;
        node.begin = begin;
        node.end = end;
        cda::Box middles;
        for (std::size_t i = begin; i < end; ++i) {
            for (std::size_t k = 0; k < 3; ++k)
                node.box.add(corner(order_[i], k));
            middles.add(middle(order_[i]));
        }
        nodes_.push_back(node);
        if (end - begin <= kLeaf) return number;
        const Vec3 size = middles.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t half = begin + (end - begin) / 2;
        const auto at = [&](std::size_t i) {
            return order_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(begin), at(half), at(end), [&](std::uint32_t s, std::uint32_t t) {
            return middle(s)[axis] < middle(t)[axis];
        });
        const std::size_t left = build(begin, half);
        const std::size_t right = build(half, end);
        nodes_[number].left = left;
        nodes_[number].right = right;
        return number;
    }

    double distance(Vec3 p, std::uint32_t t) const {
        const Vec3 a = corner(t, 0);
        const Vec3 b = corner(t, 1);
        const Vec3 c = corner(t, 2);
        const Vec3 n = cda::normalized(cda::cross(b - a, c - a));
        const auto is_left_of = [&](Vec3 from, Vec3 to) {
            return cda::dot(cda::cross(to - from, p - from), n) >= 0.0;
        };
        if (cda::norm(n) > 0.0 && is_left_of(a, b) && is_left_of(b, c) && is_left_of(c, a))
            return std::abs(cda::dot(n, p - a));
        return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c),
                         distance_to_segment(p, c, a)});
    }

    void search(std::size_t number, Vec3 p, double& nearest) const {
        const Node& node = nodes_[number];
        if (node.right == 0) {
            for (std::size_t i = node.begin; i < node.end; ++i)
                nearest = std::min(nearest, distance(p, order_[i]));
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
        if (to_first < nearest) search(first, p, nearest);
        if (to_second < nearest) search(second, p, nearest);
    }

    const cda::TriangleMesh& mesh_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

double farthest(const cda::TriangleMesh& from, const Tree& to) {
    double result = 0.0;
    std::vector<bool> is_done(from.vertices.size(), false);
    for (const auto& triangle : from.triangles) {
        Vec3 sum;
        for (const std::uint32_t v : triangle) {
            sum = sum + from.vertices[v];
            if (is_done[v]) continue;
            is_done[v] = true;
            result = std::max(result, to.distance(from.vertices[v]));
        }
        result = std::max(result, to.distance((1.0 / 3.0) * sum));
    }
    return result;
}

}  // namespace

double deviation(const cda::TriangleMesh& a, const cda::TriangleMesh& b) {
    return std::max(farthest(a, Tree(b)), farthest(b, Tree(a)));
}

}  // namespace ncsim::exporter
