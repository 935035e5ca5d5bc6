// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verification of programs, several at a time.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/entry.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/recorded_input.h"

#include "check/check_settings.h"
#include "options/check_options.h"
#include "system/child_processes.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::app {

class Checking {
public:
    using Done = std::function<void(std::size_t, report::Entry)>;
    using Noted = std::function<void(std::size_t)>;

    /// Creates an object for `programs`.
    /// Requires: all arguments outlive the object.
    Checking(const CheckOptions& options, const std::vector<std::string>& programs,
             SettingsOfPrograms& settings, setup::InputSet& inputs)
        : options_(options), programs_(programs), settings_(settings), inputs_(inputs) {}

    /// Verifies the programs `which`. Calls done(i, entry) for each i of `which` in order, and
    /// noted(n) as soon as n programs are finished. Returns the number of programs begun: all,
    /// unless an Interruption occurs.
    std::size_t run(const std::vector<std::size_t>& which, const Done& done, const Noted& noted);

    /// Returns the entry of a program that was not begun.
    report::Entry not_reached(std::size_t program) const;

    /// Sets `shows`, which is called for each program that needs a page, on the thread that judged
    /// the program.
    void show(std::function<void(std::size_t, report::Checked)> shows) {
        shows_ = std::move(shows);
    }

private:
    /// Result of a program, with the files on which it depends.
    struct CheckResult {
        report::Entry entry;
        setup::ReadFiles files;
        bool knows_all = true;  ///< `files` is complete.
    };

    std::size_t run_isolated(const std::vector<std::size_t>& which, unsigned jobs, unsigned threads,
                             const Done& done, const Noted& noted);
    report::Entry verified(std::size_t program, unsigned threads, const std::stop_token& stop);
    CheckResult checked_result(std::size_t program, unsigned threads, const std::stop_token& stop);
    report::Entry entry_of_end(std::size_t program, const ProcessEnd& end);
    report::Entry failed(std::size_t program, const std::string& why, int code) const;
    std::optional<report::Entry> known(std::size_t program) const;
    void keep(std::size_t program, const CheckResult& found) const;

    const CheckOptions& options_;
    const std::vector<std::string>& programs_;
    SettingsOfPrograms& settings_;
    setup::InputSet& inputs_;
    std::function<void(std::size_t, report::Checked)> shows_;
};

}  // namespace ncsim::app
