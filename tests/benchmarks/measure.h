// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tools for measurements.
#pragma once

#include <functional>
#include <string>

namespace ncsim::bench {

/// Returns the processor time of this process in seconds, over all threads.
double cpu_seconds();

/// Runs `measure` in a separate process, so memory is that of a single measurement. After a crash,
/// or after `seconds` (0: no limit), prints a row of `title` with the reason.
void apart(const std::string& title, unsigned seconds, const std::function<void()>& measure);

}  // namespace ncsim::bench
