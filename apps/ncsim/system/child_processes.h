// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parallel work, each piece in a separate process, with results in order. A crash of a piece does
// not affect the rest.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace ncsim::app {

/// End of the process of a piece of work.
struct ProcessEnd {
    std::string output;       ///< Result; only if has_succeeded().
    int signal = 0;           ///< Signal that ended the process; 0: none.
    int exit_code = 0;        ///< Exit code without a signal.
    bool is_late = false;     ///< Killed because the time ran out.
    bool is_stopped = false;  ///< Killed because the work was stopped.

    bool has_succeeded() const { return signal == 0 && exit_code == 0; }
};

/// Functions for in_processes(). All except `work` run in the process of the caller.
struct ProcessWork {
    /// True if piece i needs work. Otherwise `done` receives an empty end.
    std::function<bool(std::size_t)> is_needed;
    std::function<std::string(std::size_t)> work;
    /// Returns the time limit of piece i in seconds; 0: none.
    std::function<double(std::size_t)> seconds;
    std::function<void(std::size_t, ProcessEnd)> done;
    /// Called with the number of finished pieces.
    std::function<void(std::size_t)> noted;
    /// Descriptor that becomes readable to stop: no further piece begins, and running pieces are
    /// killed. -1: none.
    int stop_descriptor = -1;
};

/// Runs work(i) for all i below `count` in processes, `jobs` at a time, and calls done(i) in the
/// order of i. No process remains if an exception is thrown.
/// Requires: the caller has no second thread, because a process inherits only one.
/// Returns: the number of pieces begun; `count` unless the work was stopped.
/// Throws: std::runtime_error if no process can be created, and exceptions of the functions of
///   `pieces`.
std::size_t run_in_processes(std::size_t count, unsigned jobs, const ProcessWork& pieces);

}  // namespace ncsim::app
