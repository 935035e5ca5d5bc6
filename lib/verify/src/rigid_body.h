// SPDX-License-Identifier: GPL-3.0-or-later
//
// A body that moves as a whole: convex pieces that cover it, those that lie inside of it, and a
// tree of boxes to find the ones that are near something.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/mesh.h"
#include "ncsim/cda/separation.h"
#include "ncsim/cda/vec.h"
#include "ncsim/machine/pose.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::verify {

/// Corners of a convex piece, mm; in machine coordinates with all joints at 0.
struct ConvexPiece {
    std::vector<cda::Vec3> outer;  ///< Their hull has all of the piece;
    std::vector<cda::Vec3> inner;  ///< theirs only what is certainly there; may be empty.
    cda::Directions directions;    ///< Of the inner hull.
    bool assumed = false;          ///< Nobody told it.
};

class RigidBody;

/// A polytope that was made on `lattice` about `centre` (mm): outer and inner corners are its own.
ConvexPiece piece_of(const cda::ConvexPolytope& polytope, const cda::Lattice& lattice,
                     cda::Vec3 centre);
/// A body whose surface is that, within `deflection_mm`, in pieces that convex_pieces() cuts it
/// into. Throws what that does.
RigidBody body_in_pieces(const cda::TriangleMesh& mesh, double deflection_mm = 0.0);
/// Why a mesh counts as its convex hull; empty: it does not.
std::string why_as_hull(const cda::TriangleMesh& mesh, bool told);
/// The convex hull of its corners, of which nothing is certainly there.
RigidBody hull_of(const cda::TriangleMesh& mesh, double deflection_mm);

class RigidBody {
public:
    /// `accuracy_mm`: outer hulls miss no point of the body by more, nor have inner ones a point
    /// farther outside. At least one piece.
    RigidBody(std::vector<ConvexPiece> pieces, double accuracy_mm);

    struct Node {
        cda::Box box;
        std::uint32_t begin = 0, end = 0;   ///< In order().
        std::uint32_t left = 0, right = 0;  ///< 0: a leaf.
    };
    const std::vector<ConvexPiece>& pieces() const { return pieces_; }
    const std::vector<cda::Box>& boxes() const { return boxes_; }  ///< Of the pieces.
    const std::vector<Node>& nodes() const { return nodes_; }      ///< The root first.
    const std::vector<std::uint32_t>& order() const { return order_; }
    double accuracy_mm() const { return accuracy_mm_; }
    cda::Vec3 centre() const { return nodes_[0].box.centre(); }
    double radius() const { return radius_; }  ///< Of a ball about it with all of the body.
    /// Of the longest side of a piece.
    double longest() const { return longest_; }

private:
    std::uint32_t build(std::uint32_t begin, std::uint32_t end);

    std::vector<ConvexPiece> pieces_;
    std::vector<cda::Box> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
    double accuracy_mm_ = 0.0;
    double radius_ = 0.0;
    double longest_ = 0.0;
};

/// A box around another one as it is turned.
cda::Box placed(const machine::Pose& X, const cda::Box& box);

}  // namespace ncsim::verify
