// SPDX-License-Identifier: GPL-3.0-or-later
//
// Creates rigid bodies and their trees of boxes.
#include "rigid_body.h"

#include "ncsim/cda/shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ncsim::verify {

ConvexPiece piece_of(const cda::ConvexPolytope& polytope, const cda::Lattice& lattice,
                     Vec3 centre) {
    ConvexPiece piece;
    for (const cda::ExactPoint& corner : polytope.vertices())
        piece.outer.push_back(lattice.to_mm(corner.approx) + centre);
    piece.inner = piece.outer;
    piece.directions = cda::directions_of(polytope);
    return piece;
}

RigidBody body_in_pieces(const TriangleMesh& mesh, double deflection_mm) {
    // Moved to the origin, where the lattice is finest.
    Box box;
    for (const Vec3& p : mesh.vertices)
        box.add(p);
    const Vec3 centre = box.centre();
    TriangleMesh near = mesh;
    for (Vec3& p : near.vertices)
        p = p - centre;
    const cda::Lattice lattice = cda::Lattice::for_stock({box.min - centre, box.max - centre});
    std::vector<ConvexPiece> pieces;
    for (const cda::ConvexPolytope& polytope : cda::convex_pieces(near, lattice))
        pieces.push_back(piece_of(polytope, lattice, centre));
    // Two units of the surface, and rounding of the corners.
    return {std::move(pieces), 3.0 * lattice.unit_mm + deflection_mm};
}

std::string reason_for_hull(const TriangleMesh& mesh, bool specified) {
    // larger meshes take longer to divide than a program to verify
    constexpr std::size_t kMostTriangles = 50'000;
    if (specified) return "that was specified";
    if (mesh.triangles.size() > kMostTriangles) return "it has more than 50,000 triangles";
    return {};
}

RigidBody hull_of(const TriangleMesh& mesh, double deflection_mm) {
    return {{ConvexPiece{mesh.vertices, {}, {}, false}}, deflection_mm};
}

RigidBody::RigidBody(std::vector<ConvexPiece> pieces, double accuracy_mm)
    : pieces_(std::move(pieces)), order_(pieces_.size()), accuracy_mm_(accuracy_mm) {
    for (const ConvexPiece& piece : pieces_) {
        Box box;
        for (const Vec3& p : piece.outer)
            box.add(p);
        const Vec3 size = box.size();
        longest_ = std::max({longest_, size.x, size.y, size.z});
        boxes_.push_back(box);
    }
    std::iota(order_.begin(), order_.end(), 0U);
    nodes_.reserve(2 * pieces_.size());
    build(0, static_cast<std::uint32_t>(pieces_.size()));
    for (const ConvexPiece& piece : pieces_) {
        for (const Vec3& p : piece.outer)
            radius_ = std::max(radius_, norm(p - centre()));
    }
}

std::uint32_t RigidBody::build(std::uint32_t begin, std::uint32_t end) {
    constexpr std::uint32_t kLeaf = 2;
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Node node{{}, begin, end, 0, 0};
    for (std::uint32_t i = begin; i < end; ++i)
        node.box.add(boxes_[order_[i]]);
    if (end - begin > kLeaf) {
        const Vec3 size = node.box.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto before = [&](std::uint32_t a, std::uint32_t b) {
            const double at_a = boxes_[a].centre()[axis], at_b = boxes_[b].centre()[axis];
            return at_a != at_b ? at_a < at_b : a < b;
        };
        std::sort(order_.begin() + begin, order_.begin() + end, before);
        const std::uint32_t middle = begin + (end - begin) / 2;
        node.left = build(begin, middle);
        node.right = build(middle, end);
    }
    nodes_[number] = node;
    return number;
}

Box placed(const machine::Pose& X, const Box& box) {
    const Vec3 centre = X * box.centre();
    const Vec3 half = 0.5 * box.size();
    Vec3 reach;
    for (int i = 0; i < 3; ++i) {
        const Vec3& row = X.rows[static_cast<std::size_t>(i)];
        reach[i] = std::abs(row.x) * half.x + std::abs(row.y) * half.y + std::abs(row.z) * half.z;
    }
    return {centre - reach, centre + reach};
}

}  // namespace ncsim::verify
