// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the tool is: the pose of lib/machine, under the name it has here.
#pragma once

#include "ncsim/machine/pose.h"

namespace ncsim::toolpath {

using machine::Pose;

}  // namespace ncsim::toolpath
