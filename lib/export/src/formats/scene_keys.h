// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keys of joints and of visibility for files with animation.
#pragma once

#include "ncsim/export/moving_scene.h"

#include <vector>

namespace ncsim::exporter {

/// True if any key of `joint` differs from its first key.
bool is_moving(const SceneJoint& joint);
/// Returns the value of the first key; 0 without keys.
double first_value(const SceneJoint& joint);
/// Returns the keys of `joint`. If it is a rotary joint, keys are inserted so that successive keys
/// differ by at most `most_degrees`.
std::vector<JointKey> divided_keys(const SceneJoint& joint, double most_degrees);

/// Returns the times at which `node` becomes visible (1) or hidden (0). The first key is at 0 s.
std::vector<JointKey> visibility_keys(const SceneNode& node);

}  // namespace ncsim::exporter
