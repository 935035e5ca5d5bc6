// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keys of joints and of visibility for files with animation.
#include "formats/scene_keys.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ncsim::exporter {

bool is_moving(const SceneJoint& joint) {
    return std::ranges::any_of(joint.keys, [&joint](const JointKey& key) {
        return key.value != joint.keys.front().value;
    });
}

double first_value(const SceneJoint& joint) {
    return joint.keys.empty() ? 0.0 : joint.keys.front().value;
}

std::vector<JointKey> divided_keys(const SceneJoint& joint, double most_degrees) {
    std::vector<JointKey> keys;
    for (std::size_t i = 0; i < joint.keys.size(); ++i) {
        const JointKey& to = joint.keys[i];
        if (i > 0 && joint.turns) {
            const JointKey& from = joint.keys[i - 1];
            const auto parts =
                static_cast<std::size_t>(std::ceil(std::abs(to.value - from.value) / most_degrees));
            for (std::size_t part = 1; part < parts; ++part) {
                const double share = static_cast<double>(part) / static_cast<double>(parts);
                keys.push_back({from.seconds + share * (to.seconds - from.seconds),
                                from.value + share * (to.value - from.value)});
            }
        }
        keys.push_back(to);
    }
    return keys;
}

std::vector<JointKey> visibility_keys(const SceneNode& node) {
    std::vector<JointKey> keys{{0.0, 0.0}};
    const auto change = [&keys](double seconds, double value) {
        if (keys.back().seconds >= seconds) {
            keys.back().value = value;
        } else {
            keys.push_back({seconds, value});
        }
    };
    for (const auto& [from, to] : node.shown) {
        change(from, 1.0);
        change(to, 0.0);
    }
    return keys;
}

}  // namespace ncsim::exporter
