// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies programs, several at a time.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/entry.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/recorded_input.h"

#include "check/check_settings.h"
#include "options/check_options.h"
#include "system/in_processes.h"

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

    /// All of them must outlive it.
    Checking(const CheckOptions& options, const std::vector<std::string>& programs,
             SettingsOfPrograms& settings, setup::InputSet& inputs)
        : options_(options), programs_(programs), settings_(settings), inputs_(inputs) {}

    /// Calls done(i, entry) for each i of `which`, in that order, and noted(n) as soon as n of them
    /// are finished. Returns how many were begun: all, unless there is an Interruption.
    std::size_t run(const std::vector<std::size_t>& which, const Done& done, const Noted& noted);

    /// What there is to say of a program that was not begun.
    report::Entry not_reached(std::size_t program) const;

    /// Calls `shows` for each program for which a page is asked, from the thread that judged it.
    void show(std::function<void(std::size_t, report::Checked)> shows) {
        shows_ = std::move(shows);
    }

private:
    /// What was found, and what it depends on.
    struct Found {
        report::Entry entry;
        setup::ReadFiles files;
        bool knows_all = true;  ///< They are all.
    };

    std::size_t run_isolated(const std::vector<std::size_t>& which, unsigned jobs, unsigned threads,
                             const Done& done, const Noted& noted);
    report::Entry verified(std::size_t program, unsigned threads, const std::stop_token& stop);
    Found found(std::size_t program, unsigned threads, const std::stop_token& stop);
    report::Entry from(std::size_t program, const ProcessEnd& end);
    report::Entry failed(std::size_t program, const std::string& why, int code) const;
    std::optional<report::Entry> known(std::size_t program) const;
    void keep(std::size_t program, const Found& found) const;

    const CheckOptions& options_;
    const std::vector<std::string>& programs_;
    SettingsOfPrograms& settings_;
    setup::InputSet& inputs_;
    std::function<void(std::size_t, report::Checked)> shows_;
};

}  // namespace ncsim::app
