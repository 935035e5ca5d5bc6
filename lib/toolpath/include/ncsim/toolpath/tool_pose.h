// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pose of the tool: the type of lib/machine, under the name of this library.
#pragma once

#include "ncsim/machine/pose.h"

namespace ncsim::toolpath {

using machine::Pose;

}  // namespace ncsim::toolpath
