// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains between two bodies, and bounds of their relative motion.
#include "ncsim/machine/relative.h"

#include "ncsim/base/angles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ncsim::machine {

namespace {

double distance_from_axis(Vec3 p, const Joint& joint) {
    const Vec3 out = p - joint.through;
    return norm(out - dot(out, joint.direction) * joint.direction);
}

}  // namespace

Chain seen_from(const Chain& observer, const Chain& body) {
    std::size_t common = 0;
    while (common < observer.joints.size() && common < body.joints.size() &&
           observer.joints[common] == body.joints[common]) {
        ++common;
    }
    Chain chain;
    for (std::size_t i = observer.joints.size(); i-- > common;) {
        Joint back = observer.joints[i];
        back.direction = -back.direction;
        chain.joints.push_back(back);
    }
    for (std::size_t i = common; i < body.joints.size(); ++i)
        chain.joints.push_back(body.joints[i]);
    return chain;
}

Pose pose_of(const Chain& moved_by, const Values& values) {
    Pose X;
    for (const Joint& joint : moved_by.joints) {
        const double value = values[*index_of(joint.letter)];
        if (value != 0.0) X = X * pose_of(joint, value);
    }
    return X;
}

Pose inverse(const Pose& X_AB) {
    const auto& r = X_AB.rows;
    Pose X_BA;
    X_BA.rows = {{{r[0].x, r[1].x, r[2].x}, {r[0].y, r[1].y, r[2].y}, {r[0].z, r[1].z, r[2].z}}};
    X_BA.translation = -(X_BA * X_AB.translation);
    return X_BA;
}

Ball move_ball(const Chain& chain, const JointMotion& joint_motion, Ball body) {
    const auto& joints = chain.joints;
    for (std::size_t i = joints.size(); i-- > 0;) {
        const Joint& joint = joints[i];
        const std::size_t letter = *index_of(joint.letter);
        const double from = joint_motion.from[letter], to = joint_motion.to[letter];
        if (joint.turns) {
            const double turn = kRadiansPerDegree * std::abs(to - from);
            const double aside = distance_from_axis(body.centre, joint);
            const double distance = aside + body.radius;
            body.bend += turn * turn * distance + 2.0 * turn * body.speed;
            body.speed += turn * distance;
            body.centre = move_by_joint(joint, 0.5 * (from + to), body.centre);
            // The distance of the centre from the middle position is at most the arc, and at most
            // the
            // diameter.
            body.radius += std::min(0.5 * turn, 2.0) * aside;
            continue;
        }
        // Consecutive linear joints are combined into one translation.
        double square = 0.0;
        bool is_of_three = true;  // X, Y and Z
        std::size_t first = i + 1;
        for (; first > 0 && !joints[first - 1].turns; --first) {
            const std::size_t axis = *index_of(joints[first - 1].letter);
            const double way = std::abs(joint_motion.to[axis] - joint_motion.from[axis]);
            const double speed = axis < joint_motion.speed.size() ? joint_motion.speed[axis] : way;
            is_of_three &= axis < joint_motion.speed.size();
            square += speed * speed;
            body.centre =
                move_by_joint(joints[first - 1],
                              0.5 * (joint_motion.from[axis] + joint_motion.to[axis]), body.centre);
        }
        double speed = std::sqrt(square);
        if (is_of_three) speed = std::min(speed, joint_motion.all_speed);
        body.speed += speed;
        body.bend += joint_motion.bend;
        body.radius += 0.5 * speed + joint_motion.bend / 8.0;
        i = first;
    }
    return body;
}

}  // namespace ncsim::machine
