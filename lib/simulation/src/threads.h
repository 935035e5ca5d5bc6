// SPDX-License-Identifier: GPL-3.0-or-later
//
// Threads of a program: strokes of taps and helices of thread mills.
#pragma once

#include "ncsim/simulation/measures.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"

#include <vector>

namespace ncsim::simulation {

/// Returns the threads in the order of their first motion. A thread is
/// - the strokes of a tap along its axis at one place, with the pitch of the tap;
/// - a turn or more of a helix of a thread mill or a slot mill, with the pitch of the helix.
///
/// The bores, countersinks and bosses of `sheet` determine the mouth, and whether a thread is
/// inside. Tools at an angle and arcs in inclined planes are not considered.
/// Cost: one interpretation of the program.
std::vector<MeasuredThread> threads_of(const Plan& plan, const Survey& survey,
                                       const MeasureSheet& sheet);

}  // namespace ncsim::simulation
