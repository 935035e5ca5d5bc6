// SPDX-License-Identifier: GPL-3.0-or-later
//
// The links of a machine as bodies that can meet something: in convex pieces, which takes a while
// and is done once for all programs.
#pragma once

#include "ncsim/cda/mesh.h"
#include "ncsim/machine/chain.h"

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
};

/// Names of links and fixtures; "tool" and "part" are what they say.
using NamePair = std::pair<std::string, std::string>;

/// All of them, and what else counts for whom is asked about whom.
struct LinkBodies {
    std::vector<LinkBody> links;
    machine::Chain part_moved_by, tool_moved_by;  ///< As LinkBody::moved_by.
    std::vector<NamePair> ignored;                ///< Not asked about each other,
    std::vector<NamePair> asked;                  ///< and asked though they are neighbours.
};

/// Immutable, so threads may share it.
class MachineBodies {
public:
    /// A mesh that crosses itself, or is of very many pieces, counts as its convex hull: what does
    /// not meet that is clear, and what meets it is open.
    explicit MachineBodies(LinkBodies told);
    ~MachineBodies();
    MachineBodies(const MachineBodies&) = delete;
    MachineBodies& operator=(const MachineBodies&) = delete;

    const LinkBodies& told() const { return told_; }
    /// Of a link; null where it has no mesh.
    const RigidBody* body(std::size_t link) const { return bodies_[link].get(); }
    /// Why it counts as its hull; empty: it does not.
    const std::string& taken_as_hull(std::size_t link) const { return taken_as_hull_[link]; }
    /// Is any mesh told?
    bool has_meshes() const;

private:
    LinkBodies told_;
    std::vector<std::unique_ptr<const RigidBody>> bodies_;
    std::vector<std::string> taken_as_hull_;
};

}  // namespace ncsim::verify
