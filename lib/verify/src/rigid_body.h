// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rigid body: convex pieces that cover the body, convex pieces inside the body, and a tree of boxes
// to find pieces near a place.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/base/vec3.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/separation.h"
#include "ncsim/machine/pose.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::verify {

/// Corners of a convex piece; mm, machine coordinates with all joints at 0.
struct ConvexPiece {
    std::vector<Vec3> outer;     ///< Their hull contains the piece.
    std::vector<Vec3> inner;     ///< Their hull is inside the piece; may be empty.
    cda::Directions directions;  ///< Directions of the inner hull.
    bool assumed = false;        ///< The piece is not specified.
};

class RigidBody;

/// Returns the piece of a polytope on `lattice` about `centre` (mm); outer and inner corners are
/// equal.
ConvexPiece piece_of(const cda::ConvexPolytope& polytope, const cda::Lattice& lattice, Vec3 centre);
/// Returns a body with the surface `mesh`, within `deflection_mm`, divided by convex_pieces().
/// Throws: as convex_pieces().
RigidBody body_in_pieces(const TriangleMesh& mesh, double deflection_mm = 0.0);
/// Returns the reason why the hull replaces a mesh: a request of the user, or a large mesh; empty:
/// it does not.
std::string reason_for_hull(const TriangleMesh& mesh, bool specified);
/// Returns the convex hull of the corners as a body without inner pieces.
RigidBody hull_of(const TriangleMesh& mesh, double deflection_mm);

class RigidBody {
public:
    /// Creates a body. `accuracy_mm`: largest distance of a point of the body from the outer hulls,
    /// and of a point of the inner hulls from the body.
    /// Requires: at least one piece.
    RigidBody(std::vector<ConvexPiece> pieces, double accuracy_mm);

    struct Node {
        Box box;
        std::uint32_t begin = 0, end = 0;   ///< Range in order().
        std::uint32_t left = 0, right = 0;  ///< Children; 0: a leaf.
    };
    const std::vector<ConvexPiece>& pieces() const { return pieces_; }
    const std::vector<Box>& boxes() const { return boxes_; }   ///< Boxes of the pieces.
    const std::vector<Node>& nodes() const { return nodes_; }  ///< The root is first.
    const std::vector<std::uint32_t>& order() const { return order_; }
    double accuracy_mm() const { return accuracy_mm_; }
    Vec3 centre() const { return nodes_[0].box.centre(); }
    /// Radius of a ball about centre() that contains the body.
    double radius() const { return radius_; }
    /// Returns the length of the longest side of the box of a piece.
    double longest() const { return longest_; }

private:
    std::uint32_t build(std::uint32_t begin, std::uint32_t end);

    std::vector<ConvexPiece> pieces_;
    std::vector<Box> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
    double accuracy_mm_ = 0.0;
    double radius_ = 0.0;
    double longest_ = 0.0;
};

/// Returns a box around the transformed `box`.
Box placed(const machine::Pose& X, const Box& box);

}  // namespace ncsim::verify
