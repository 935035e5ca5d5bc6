// SPDX-License-Identifier: GPL-3.0-or-later
//
// A closed surface of triangles, ready to be asked what lies near a place and what is inside: a
// tree of boxes, halved at the median of the triangles' middles along the longest side.
#pragma once

#include "ncsim/cda/mesh.h"
#include "ncsim/cda/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::cda {

using Corners = std::array<Vec3, 3>;

Corners corners_of(const TriangleMesh& mesh, std::uint32_t triangle);

/// Of a point and a segment, mm.
double distance_to_segment(Vec3 p, Vec3 a, Vec3 b);

/// Of a point and a triangle with all of its border, mm. Triangles without area are segments.
double distance(Vec3 p, const Corners& triangle);

class TriangleTree {
public:
    /// Keeps a reference to `mesh`. O(n log n).
    explicit TriangleTree(const TriangleMesh& mesh);
    /// Of some of its triangles only: those of one surface, for instance.
    TriangleTree(const TriangleMesh& mesh, std::vector<std::uint32_t> triangles);

    struct Nearest {
        double distance_mm = Box::kInf;
        std::uint32_t triangle = 0;
    };
    /// The triangle nearest to `p`; infinitely far for an empty mesh. Expected O(log n).
    Nearest nearest(Vec3 p) const;

    /// Is `p` inside of the surface? By the signed crossings of a ray, so that bodies may overlap.
    /// Not on the surface, nor nearer to it than rounding.
    bool contains(Vec3 p) const;

    /// Calls `take` for every triangle in a box that `wants` accepts, in an order that depends on
    /// the mesh only.
    template <class Wants, class Take>
    void visit(const Wants& wants, const Take& take) const {
        if (nodes_.empty()) return;
        // Halves of halves: one node waits for each level, of which there are 32 at most.
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

/// Does the box have a point of the segment from `a` to `b`, or one nearly so? Never a wrong no.
bool meets_segment(const Box& box, Vec3 a, Vec3 b);

}  // namespace ncsim::cda
