// SPDX-License-Identifier: GPL-3.0-or-later
//
// The links of a machine as bodies that can meet something: in convex pieces, which takes a while
// and is done once for all programs.
#pragma once

#include "ncsim/cda/mesh.h"
#include "ncsim/machine/chain.h"
#include "ncsim/verify/machine.h"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::verify {

class RigidBody;

/// A link as it was told. Machine coordinates with all joints at 0, mm.
struct LinkBody {
    std::string name;
    cda::TriangleMesh mesh;     ///< Closed; without triangles: nobody told what it looks like.
    machine::Chain moved_by;    ///< From the bed on, each joint as it moves the link.
    double clearance_mm = 0.0;  ///< Everything else is to stay this far away.
    /// How far the mesh may be from the link that it stands for: what meets it by less is open, and
    /// what keeps away from it by less, too.
    double deflection_mm = 0.0;
    std::string mesh_at{};  ///< Where the mesh was told: "mill.toml:12:1".
    bool as_hull = false;   ///< Its convex hull stands for it: what meets that is open.
};

/// Names of links and fixtures; "tool" and "part" are what they say.
using NamePair = std::pair<std::string, std::string>;

/// All of them, and what else counts for whom is asked about whom.
struct LinkBodies {
    std::vector<LinkBody> links;
    std::vector<Fixture> fixtures;                ///< Of the same machine: refused as links are.
    machine::Chain part_moved_by, tool_moved_by;  ///< As LinkBody::moved_by.
    std::vector<NamePair> ignored;                ///< Not asked about each other,
    std::vector<NamePair> asked;                  ///< and asked though they are neighbours.
};

/// Immutable, so threads may share it.
class MachineBodies {
public:
    /// A mesh of very many triangles, or one of which that was told, counts as its convex hull:
    /// what does not meet that is clear, and what meets it is open. Throws std::runtime_error for
    /// one that crosses itself, naming where it was told.
    explicit MachineBodies(LinkBodies told);
    ~MachineBodies();
    MachineBodies(const MachineBodies&) = delete;
    MachineBodies& operator=(const MachineBodies&) = delete;

    const LinkBodies& told() const { return told_; }
    /// Of a link; null where it has no mesh.
    const RigidBody* body(std::size_t link) const { return links_[link].shape.get(); }
    /// Why it counts as its hull; empty: it does not.
    const std::string& why_hull(std::size_t link) const { return links_[link].why_hull; }
    /// Is any mesh told?
    bool has_meshes() const;

private:
    struct Body {
        std::unique_ptr<const RigidBody> shape;  // null: there is no mesh
        std::string why_hull;
    };
    LinkBodies told_;
    std::vector<Body> links_;
};

}  // namespace ncsim::verify
