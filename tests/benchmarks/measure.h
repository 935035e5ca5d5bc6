// SPDX-License-Identifier: GPL-3.0-or-later
//
// What measuring takes.
#pragma once

#include <functional>
#include <string>

namespace ncsim::bench {

/// Processor time of this process, all threads.
double cpu_seconds();

/// Runs `measure` in a process of its own: memory is that of one, and what crashes or takes longer
/// than `seconds` (0: whatever it takes) leaves a row of `title` that says so.
void apart(const std::string& title, unsigned seconds, const std::function<void()>& measure);

}  // namespace ncsim::bench
