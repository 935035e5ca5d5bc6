// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIGINT, SIGTERM and SIGHUP as a reportable event that does not end the program.
#pragma once

#include <functional>
#include <string>
#include <thread>

namespace ncsim::app {

/// Scope in which the first of the signals is noted; the next signal has the effect from before the
/// scope. Ignored signals stay ignored. Scopes do not overlap.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// Returns the signal that was noted; 0: none.
    static int signal();
    /// Returns the name of the signal: "SIGINT".
    static std::string name();
    /// Returns a descriptor that becomes readable when a signal is noted.
    static int descriptor();

    /// Ends the process by the noted signal with the default effect; does nothing without a signal.
    static void raise_again();
};

/// Scope in which a signal calls `act` on a separate thread.
class InterruptionScope {
public:
    explicit InterruptionScope(std::function<void()> act);
    ~InterruptionScope();
    InterruptionScope(const InterruptionScope&) = delete;
    InterruptionScope& operator=(const InterruptionScope&) = delete;

private:
    int stop_[2];
    std::thread thread_;
};

}  // namespace ncsim::app
