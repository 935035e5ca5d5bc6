// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies programs, several at a time.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/entry.h"
#include "ncsim/setup/input.h"

#include "check_options.h"
#include "check_settings.h"

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace ncsim::app {

class Checking {
public:
    /// All of them must outlive it.
    Checking(const CheckOptions& options, const std::vector<std::string>& programs,
             SettingsOfPrograms& settings, setup::InputSet& inputs)
        : options_(options), programs_(programs), settings_(settings), inputs_(inputs) {}

    /// Calls done(i, entry) for each i of `which`, in that order.
    void run(const std::vector<std::size_t>& which,
             const std::function<void(std::size_t, report::Entry)>& done);

    /// The program of a page, of which there is but one.
    const report::Checked& looked_at() const { return looked_at_; }

private:
    report::Entry entry_for(std::size_t program, unsigned threads, const std::stop_token& stop);
    report::Entry verified(std::size_t program, unsigned threads, const std::stop_token& stop);

    const CheckOptions& options_;
    const std::vector<std::string>& programs_;
    SettingsOfPrograms& settings_;
    setup::InputSet& inputs_;
    report::Checked looked_at_;
};

}  // namespace ncsim::app
