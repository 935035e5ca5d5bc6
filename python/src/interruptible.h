// SPDX-License-Identifier: GPL-3.0-or-later
//
// Work without Python's global interpreter lock that KeyboardInterrupt ends.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <stop_token>

namespace ncsim::python {

/// Time between two checks for signals.
inline constexpr std::chrono::milliseconds kSignalPeriod{50};

/// Runs `work` (a function of a std::stop_token) on a thread, without the global interpreter lock,
/// and returns its result. A signal whose Python handler raises an exception, as for
/// KeyboardInterrupt, requests a stop.
/// Throws: the exception of `work`; pybind11::error_already_set after a signal.
/// Requires: the caller holds the lock; `work` uses no Python object.
template <class Work>
auto interruptible(Work work) {
    std::stop_source stop;
    auto result =
        std::async(std::launch::async, [&work, token = stop.get_token()] { return work(token); });
    bool is_interrupted = false;
    {
        const pybind11::gil_scoped_release release;
        while (!is_interrupted && result.wait_for(kSignalPeriod) == std::future_status::timeout) {
            const pybind11::gil_scoped_acquire acquire;
            is_interrupted = PyErr_CheckSignals() != 0;
        }
        if (is_interrupted) stop.request_stop();
        result.wait();
    }
    // The Python error of the signal replaces the failure of the stopped work.
    if (is_interrupted) throw pybind11::error_already_set();
    return result.get();
}

}  // namespace ncsim::python
