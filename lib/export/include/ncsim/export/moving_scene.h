// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine with a part and tools in it that move: a tree of nodes, each with at most one joint
// between it and the one that carries it. What files can tell that have animations.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/export/overlay.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::exporter {

/// Where a joint stands at one time: mm or degrees.
struct JointKey {
    double seconds = 0.0;
    double value = 0.0;
};

/// As it moves the node: along `direction`, or about it with the right hand through the node's
/// origin.
struct SceneJoint {
    char letter = 'X';
    bool turns = false;
    cda::Vec3 direction;         ///< Of unit length.
    std::vector<JointKey> keys;  ///< By time, which rises; evenly from each to the next.
};

/// All in machine coordinates M, mm, with all joints at 0. Frames of nodes are parallel to M then.
struct SceneNode {
    std::string name;
    std::optional<std::size_t> parent;  ///< One that stands before it; none: what does not move.
    cda::Vec3 origin;                   ///< Of its frame.
    std::optional<SceneJoint> joint;
    std::vector<Body> bodies;
    /// It is there from the first to the second, seconds, again and again; none: always.
    std::vector<std::pair<double, double>> shown;
};

struct SceneLine {
    double seconds = 0.0;  ///< When it begins.
    std::uint32_t line = 0;
};

struct MovingScene {
    std::vector<SceneNode> nodes;
    /// Which of them carries the part; none: what does not move.
    std::optional<std::size_t> part_on;
    cda::Vec3 zero;        ///< Of W, with all joints at 0.
    double seconds = 0.0;  ///< How long it all takes.
    /// Between keys nothing is farther than this from where it is in truth.
    double missed_mm = 0.0;
    std::vector<SceneLine> lines;
};

}  // namespace ncsim::exporter
