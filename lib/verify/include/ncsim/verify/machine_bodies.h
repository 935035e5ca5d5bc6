// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collision bodies of the links of a machine. The decomposition into convex pieces is slow and is
// done once for all programs.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/machine/chain.h"
#include "ncsim/verify/machine_description.h"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::verify {

class RigidBody;

/// Link as specified; mm, machine coordinates with all joints at 0.
struct LinkBody {
    std::string name;
    TriangleMesh mesh;          ///< Closed; without triangles: the shape is unspecified.
    machine::Chain moved_by;    ///< Chain from the bed; each joint as it moves the link.
    double clearance_mm = 0.0;  ///< Distance that all other bodies must keep.
    /// Largest distance (mm) of the mesh from the true surface of the link. Overlaps and distances
    /// below this value are open.
    double deflection_mm = 0.0;
    std::string mesh_at{};  ///< Place of the specification: "mill.toml:12:1".
    bool as_hull = false;   ///< The convex hull replaces the mesh; contacts with the hull are open.
};

/// Names of links and fixtures; "tool" and "part" stand for the tool and the part.
using NamePair = std::pair<std::string, std::string>;

/// Links and fixtures of a machine, with the pairs that are excluded and included.
struct LinkBodies {
    std::vector<LinkBody> links;
    /// Fixtures of the machine; their meshes are checked like meshes of links.
    std::vector<Fixture> fixtures;
    machine::Chain part_moved_by, tool_moved_by;  ///< Chains as in LinkBody::moved_by.
    std::vector<NamePair> ignored;                ///< Pairs that are not checked.
    /// Pairs of neighbours that are checked nevertheless.
    std::vector<NamePair> checked_neighbours;
};

/// Links as bodies in convex pieces. Immutable, so threads may share an object.
class MachineBodies {
public:
    /// Divides the meshes into convex pieces. A mesh with more than 50,000 triangles, or with
    /// `as_hull`, is replaced by the convex hull: no contact with the hull means clear, a contact
    /// with the hull is open.
    /// Throws: std::runtime_error for a mesh that crosses itself; the message names the place of
    ///   the specification.
    explicit MachineBodies(LinkBodies specified);
    ~MachineBodies();
    MachineBodies(const MachineBodies&) = delete;
    MachineBodies& operator=(const MachineBodies&) = delete;

    const LinkBodies& specified() const { return specified_; }
    /// Returns the body of link `link`; null without a mesh.
    const RigidBody* body(std::size_t link) const { return links_[link].shape.get(); }
    /// Returns the reason why the hull replaces the mesh of link `link`; empty: it does not.
    const std::string& hull_reason(std::size_t link) const { return links_[link].hull_reason; }
    /// True if a link has a mesh.
    bool has_meshes() const;

private:
    struct Body {
        std::unique_ptr<const RigidBody> shape;  // null: no mesh
        std::string hull_reason;
    };
    LinkBodies specified_;
    std::vector<Body> links_;
};

}  // namespace ncsim::verify
