// SPDX-License-Identifier: GPL-3.0-or-later
//
// A closed surface of triangles with an index for queries of distance and containment: a tree of
// boxes, halved at the median of the triangles' centres along the longest side.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/base/vec3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim {

using TriangleCorners = std::array<Vec3, 3>;

/// Returns the corners of a triangle of a mesh, mm.
TriangleCorners corners_of(const TriangleMesh& mesh, std::uint32_t triangle);

/// Returns the distance of a point and a segment, mm.
double distance_to_segment(Vec3 p, Vec3 a, Vec3 b);

/// Returns the distance of a point and a triangle including border, mm. Triangles without area
/// count as segments.
double distance(Vec3 p, const TriangleCorners& triangle);

/// Index of the triangles of a mesh. Requires: the mesh outlives the index.
class TriangleTree {
public:
    /// Keeps a reference to `mesh`. Cost: O(n log n).
    explicit TriangleTree(const TriangleMesh& mesh);
    /// The same for a subset of the triangles, for instance those of one surface.
    TriangleTree(const TriangleMesh& mesh, std::vector<std::uint32_t> triangles);

    /// Result of a search: the triangle and its distance.
    struct Nearest {
        double distance_mm = Box::kInf;
        std::uint32_t triangle = 0;
    };
    /// Returns the triangle nearest to `p`; infinitely far for an empty mesh. Cost: expected O(log
    /// n).
    Nearest nearest(Vec3 p) const;

    /// True if `p` is inside the surface. Counts signed crossings of a ray, so bodies may overlap.
    /// Requires: `p` is farther from the surface than rounding errors.
    bool contains(Vec3 p) const;

    /// Calls `take` for every triangle in a box that `wants` accepts, in an order that depends only
    /// on the mesh.
    template <class Wants, class Take>
    void visit(const Wants& wants, const Take& take) const {
        if (nodes_.empty()) return;
        // Depth-first search by halving: one node waits per level, and there are at most 32 levels.
        std::array<std::size_t, 40> open{};
        for (std::size_t count = 1; count > 0;) {
            const Node& node = nodes_[open[--count]];
            if (!wants(node.box)) continue;
            if (node.right != 0) {
                open[count++] = node.right;
                open[count++] = node.left;
                continue;
            }
            for (std::size_t i = node.begin; i < node.end; ++i)
                take(order_[i]);
        }
    }

    const TriangleMesh& mesh() const { return mesh_; }

private:
    struct Node {
        Box box;
        std::size_t begin = 0, end = 0;   // in order_
        std::size_t left = 0, right = 0;  // nodes; 0: a leaf
    };
    struct Placed {
        Vec3 middle;
        std::uint32_t triangle;
    };
    std::size_t build(std::vector<Placed>& placed, std::size_t begin, std::size_t end);
    void search(std::size_t number, Vec3 p, Nearest& nearest) const;

    const TriangleMesh& mesh_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

/// True if the box contains, within rounding, a point of the segment from `a` to `b`.
/// A negative answer is exact; a positive answer may be wrong by rounding.
bool meets_segment(const Box& box, Vec3 a, Vec3 b);

}  // namespace ncsim
