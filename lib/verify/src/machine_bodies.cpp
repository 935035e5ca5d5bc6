// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divides the meshes of a machine into convex pieces.
#include "ncsim/verify/machine_bodies.h"

#include "rigid_body.h"

#include <algorithm>
#include <stdexcept>

namespace ncsim::verify {

namespace {

RigidBody pieces_of(const std::string& what, const std::string& specified_at,
                    const TriangleMesh& mesh, double deflection_mm) {
    try {
        return body_in_pieces(mesh, deflection_mm);
    } catch (const std::invalid_argument& why) {
        throw std::runtime_error(specified_at + ": the mesh of " + what + ": " + why.what() +
                                 "; mend it, or let its hull stand for it (hull = true, in TOML)");
    }
}

}  // namespace

MachineBodies::MachineBodies(LinkBodies specified) : specified_(std::move(specified)) {
    const auto add = [](const std::string& what, const auto& from) {
        Body body;
        if (!from.mesh.triangles.empty()) {
            body.hull_reason = reason_for_hull(from.mesh, from.as_hull);
            body.shape = std::make_unique<const RigidBody>(
                body.hull_reason.empty()
                    ? pieces_of(what, from.mesh_at, from.mesh, from.deflection_mm)
                    : hull_of(from.mesh, from.deflection_mm));
        }
        return body;
    };
    for (const LinkBody& link : specified_.links)
        links_.push_back(add("the link '" + link.name + "'", link));
    // Only checks the meshes: positions of fixtures differ between programs, the pieces do not.
    for (const Fixture& fixture : specified_.fixtures)
        add(name_of(fixture), fixture);
}

MachineBodies::~MachineBodies() = default;

bool MachineBodies::has_meshes() const {
    return std::ranges::any_of(links_, [](const Body& body) { return body.shape != nullptr; });
}

}  // namespace ncsim::verify
