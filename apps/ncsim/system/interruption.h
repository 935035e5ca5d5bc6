// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIGINT, SIGTERM and SIGHUP as something to tell, not as the end of the program.
#pragma once

#include <functional>
#include <string>
#include <thread>

namespace ncsim::app {

/// While there is one, the first of these signals is noted; the next one does what it did before.
/// Signals that were ignored still are. There may be one at a time.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// The signal that came; 0: none.
    static int signal();
    /// "SIGINT".
    static std::string name();
    /// Readable as soon as one came.
    static int descriptor();

    /// Ends by that signal, as it would have at first; does nothing if none came.
    static void pass_on();
};

/// Calls `act` on a thread of its own when a signal comes while there is one.
class OnInterruption {
public:
    explicit OnInterruption(std::function<void()> act);
    ~OnInterruption();
    OnInterruption(const OnInterruption&) = delete;
    OnInterruption& operator=(const OnInterruption&) = delete;

private:
    int stop_[2];
    std::thread thread_;
};

}  // namespace ncsim::app
