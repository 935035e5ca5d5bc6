// SPDX-License-Identifier: GPL-3.0-or-later
//
// Many pieces of work, each in a process of its own, their results in order: what ends one of them
// ends no other.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace ncsim::app {

/// How the process of a piece of work ended.
struct ProcessEnd {
    std::string said;         ///< What it handed over; only where it is_well().
    int signal = 0;           ///< That ended it; 0: none.
    int exit_code = 0;        ///< Else.
    bool is_late = false;     ///< It was killed, for it had no time left.
    bool is_stopped = false;  ///< It was killed, for nobody waits any more.

    bool is_well() const { return signal == 0 && exit_code == 0; }
};

/// What is to be done, in the process of the caller but for `work`.
struct ProcessWork {
    /// Is there anything to be done? Else `done` comes with an end that says nothing.
    std::function<bool(std::size_t)> is_needed;
    std::function<std::string(std::size_t)> work;
    /// How many seconds it has; 0: as many as it wants.
    std::function<double(std::size_t)> seconds;
    std::function<void(std::size_t, ProcessEnd)> done;
    /// So many are finished.
    std::function<void(std::size_t)> noted;
    /// Readable: nothing more is begun, what runs is killed. -1: nobody tells.
    int stop_descriptor = -1;
};

/// Runs work(i) for all i below `count` in processes, `jobs` at a time, and calls done(i) in the
/// order of i. Returns how many were begun: all, unless it is stopped. The caller may have no other
/// thread: a process gets but one of them. Throws std::runtime_error if there can be no process,
/// and what the others throw; nothing runs on then.
std::size_t in_processes(std::size_t count, unsigned jobs, const ProcessWork& pieces);

}  // namespace ncsim::app
