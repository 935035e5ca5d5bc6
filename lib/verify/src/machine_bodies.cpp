// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/verify/machine_bodies.h"

#include "rigid_body.h"

#include <algorithm>
#include <stdexcept>

namespace ncsim::verify {

namespace {

// More take longer to divide than programs to check.
constexpr std::size_t kMostTriangles = 50'000;

RigidBody hull_of(const LinkBody& link) {
    return {{ConvexPiece{link.mesh.vertices, {}, {}, false}}, link.deflection_mm};
}

}  // namespace

MachineBodies::MachineBodies(LinkBodies told)
    : told_(std::move(told)), bodies_(told_.links.size()), taken_as_hull_(told_.links.size()) {
    for (std::size_t i = 0; i < told_.links.size(); ++i) {
        const cda::TriangleMesh& mesh = told_.links[i].mesh;
        if (mesh.triangles.empty()) continue;
        if (mesh.triangles.size() > kMostTriangles) {
            taken_as_hull_[i] = "it has more than 50,000 triangles";
        } else {
            try {
                bodies_[i] = std::make_unique<const RigidBody>(
                    body_in_pieces(mesh, told_.links[i].deflection_mm));
            } catch (const std::invalid_argument& why) {
                taken_as_hull_[i] = why.what();
            }
        }
        if (!bodies_[i]) bodies_[i] = std::make_unique<const RigidBody>(hull_of(told_.links[i]));
    }
}

MachineBodies::~MachineBodies() = default;

bool MachineBodies::has_meshes() const {
    return std::ranges::any_of(bodies_, [](const auto& body) { return body != nullptr; });
}

}  // namespace ncsim::verify
