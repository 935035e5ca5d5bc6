// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions of machine bodies and points of the part for given joints.
#include "ncsim/setup/machine_body.h"

namespace ncsim::setup {

std::vector<Vec3> corners_at(const MachineBody& body, const machine::Values& values) {
    std::vector<Vec3> corners = body.mesh.vertices;
    const auto& joints = body.moved_by.joints;
    for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint) {
        const double value = values[*machine::index_of(joint->letter)];
        for (Vec3& p : corners)
            p = machine::move_by_joint(*joint, value, p);
    }
    return corners;
}

Vec3 on_part(const machine::Chain& moved_by, const machine::Values& values, Vec3 p_M) {
    for (const machine::Joint& joint : moved_by.joints)
        p_M = machine::move_by_joint(joint, -values[*machine::index_of(joint.letter)], p_M);
    return p_M;
}

}  // namespace ncsim::setup
