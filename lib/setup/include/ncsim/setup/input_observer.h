// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reports the names of all inputs of this process, for a caller that repeats work if a file
// changes.
#pragma once

#include <functional>
#include <string>

namespace ncsim::setup {

/// Receives the path of a file that is read or searched for, or of a folder that is listed. Called
/// from any thread, once for each access.
using InputObserver = std::function<void(const std::string& path)>;

/// Sets the observer of this process; an empty function removes the observer.
/// Requires: only this thread reads inputs.
void observe_inputs(InputObserver observer);

/// Passes `path` to the observer, if set.
void note_input(const std::string& path);

}  // namespace ncsim::setup
