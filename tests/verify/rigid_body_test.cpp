// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rigid bodies: sizes, the tree of boxes, and boxes of placed bodies.
#include "rigid_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace ncsim::verify {
namespace {

ConvexPiece block(Vec3 a, Vec3 b) {
    ConvexPiece piece;
    for (int i = 0; i < 8; ++i)
        piece.outer.push_back(
            {(i & 1) != 0 ? b.x : a.x, (i & 2) != 0 ? b.y : a.y, (i & 4) != 0 ? b.z : a.z});
    return piece;
}

TEST(RigidBody, HasTheSizesOfItsPieces) {
    const RigidBody body({block({0, 0, 0}, {2, 3, 4}), block({10, 0, 0}, {11, 7, 1})}, 0.5);
    EXPECT_EQ(body.longest(), 7.0);
    EXPECT_EQ(body.accuracy_mm(), 0.5);
    EXPECT_EQ(body.centre(), (Vec3{5.5, 3.5, 2}));
    // The corner that is farthest from the centre: (0, 0, 0), (11, 7, 0) and more.
    EXPECT_DOUBLE_EQ(body.radius(), std::sqrt(5.5 * 5.5 + 3.5 * 3.5 + 2.0 * 2.0));
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 size{1, 1, 1};
        size[axis] = 9.0;
        EXPECT_EQ(RigidBody({block({0, 0, 0}, size)}, 0.0).longest(), 9.0);
    }
    // The longest piece is not the last one.
    EXPECT_EQ(RigidBody({block({0, 0, 0}, {8, 1, 1}), block({0, 0, 0}, {1, 1, 1})}, 0.0).longest(),
              8.0);
}

TEST(RigidBody, TreeHoldsEachPieceOnceWithinItsBoxes) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<ConvexPiece> pieces;
        for (int i = 0; i < 9; ++i) {
            Vec3 at;
            at[axis] = 10.0 * ((i * 4) % 9);
            pieces.push_back(block(at, at + Vec3{1, 1, 1}));
        }
        const RigidBody body(pieces, 0.0);
        const auto& nodes = body.nodes();
        std::multiset<std::uint32_t> seen;
        for (const RigidBody::Node& node : nodes) {
            for (std::uint32_t i = node.begin; i < node.end; ++i) {
                const Box& piece = body.boxes()[body.order()[i]];
                Box both = node.box;
                both.add(piece);
                EXPECT_EQ(both, node.box);
                if (node.left == 0) seen.insert(body.order()[i]);
            }
            if (node.left == 0) {
                EXPECT_LE(node.end - node.begin, 2U);
                continue;
            }
            EXPECT_EQ(nodes[node.left].end, nodes[node.right].begin);
            EXPECT_EQ(nodes[node.left].begin, node.begin);
            EXPECT_EQ(nodes[node.right].end, node.end);
            // Halves along the longest side do not overlap.
            EXPECT_LT(nodes[node.left].box.max[axis], nodes[node.right].box.min[axis]);
        }
        EXPECT_EQ(seen.size(), 9U);
        EXPECT_EQ(std::set<std::uint32_t>(seen.begin(), seen.end()).size(), 9U);
    }
}

TEST(RigidBody, OfAMeshIsWithinItsAccuracy) {
    TriangleMesh mesh;
    mesh.vertices = block({100, 0, 0}, {104, 3, 2}).outer;
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    const RigidBody body = body_in_pieces(mesh, 0.25);
    EXPECT_GT(body.accuracy_mm(), 0.25);
    EXPECT_LT(body.accuracy_mm(), 0.2501);
    const Box& box = body.nodes().front().box;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(box.min[axis], (Vec3{100, 0, 0})[axis], 1e-4);
        EXPECT_NEAR(box.max[axis], (Vec3{104, 3, 2})[axis], 1e-4);
    }
    const RigidBody hull = hull_of(mesh, 0.1);
    EXPECT_EQ(hull.pieces().size(), 1U);
    EXPECT_TRUE(hull.pieces()[0].inner.empty());
    EXPECT_EQ(hull.accuracy_mm(), 0.1);
    EXPECT_EQ(reason_for_hull(mesh, false), "");
    EXPECT_EQ(reason_for_hull(mesh, true), "that was specified");
    mesh.triangles.resize(50'000);
    EXPECT_EQ(reason_for_hull(mesh, false), "");
    mesh.triangles.resize(50'001);
    EXPECT_EQ(reason_for_hull(mesh, false), "it has more than 50,000 triangles");
}

TEST(RigidBody, BoxOfAPlacedBoxHoldsItsCorners) {
    // A quarter turn about Z, and a move.
    machine::Pose pose;
    pose.rows = {Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}};
    pose.translation = {10, 20, 30};
    EXPECT_EQ(placed(pose, {{1, 2, 3}, {5, 4, 9}}), (Box{{6, 21, 33}, {8, 25, 39}}));
    // An eighth: the box of the diagonal.
    const double half = std::sqrt(0.5);
    pose.rows = {Vec3{half, -half, 0}, Vec3{half, half, 0}, Vec3{0, 0, 1}};
    pose.translation = {};
    const Box turned = placed(pose, {{-1, -1, 0}, {1, 1, 2}});
    EXPECT_NEAR(turned.max.x, std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(turned.min.y, -std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(turned.max.z, 2.0, 1e-12);
}

}  // namespace
}  // namespace ncsim::verify
