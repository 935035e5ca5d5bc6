// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keys of joints as files have them.
#pragma once

#include "ncsim/export/moving_scene.h"

#include <vector>

namespace ncsim::exporter {

/// Does it ever stand elsewhere than at its first key?
bool is_moving(const SceneJoint& joint);
/// Where it stands at first; 0 without keys.
double first_value(const SceneJoint& joint);
/// Its keys, with more of them where it turns by over `most_degrees` from one to the next.
std::vector<JointKey> divided_keys(const SceneJoint& joint, double most_degrees);

/// When a node comes and goes: from then on it is there (1) or not (0). The first at 0 s.
std::vector<JointKey> visibility_keys(const SceneNode& node);

}  // namespace ncsim::exporter
