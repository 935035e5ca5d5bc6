// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine with a moving part and moving tools: a tree of nodes, each with at most one joint to
// its parent. Input of the file formats that support animation.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/export/overlay.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::exporter {

/// Position of a joint at one time, in mm or degrees.
struct JointKey {
    double seconds = 0.0;
    double value = 0.0;
};

/// Joint of a node: translation along `direction`, or right-handed rotation about `direction`
/// through the origin of the node.
struct SceneJoint {
    char letter = 'X';
    bool turns = false;
    Vec3 direction;              ///< Unit vector.
    std::vector<JointKey> keys;  ///< Ascending in time; linear between keys.
};

/// Node of the tree. Values are in machine coordinates M, in mm, with all joints at 0. In that
/// position the frames of nodes are parallel to M.
struct SceneNode {
    std::string name;
    /// Number of the parent, which precedes the node; nullopt: the fixed base.
    std::optional<std::size_t> parent;
    Vec3 origin;  ///< Origin of the node's frame.
    std::optional<SceneJoint> joint;
    std::vector<Body> bodies;
    /// Intervals in seconds during which the node is visible; empty: always.
    std::vector<std::pair<double, double>> shown;
};

/// Start time of a line of the program.
struct SceneLine {
    double seconds = 0.0;  ///< Start time.
    std::uint32_t line = 0;
};

/// The machine, its motion and the lines of the program that cause it.
struct MovingScene {
    std::vector<SceneNode> nodes;
    /// Number of the node that carries the part; nullopt: the fixed base.
    std::optional<std::size_t> part_on;
    Vec3 zero;             ///< Origin of W, with all joints at 0.
    double seconds = 0.0;  ///< Duration of the motion.
    /// Largest distance between the animated and the true position between keys.
    double missed_mm = 0.0;
    std::vector<SceneLine> lines;
};

}  // namespace ncsim::exporter
