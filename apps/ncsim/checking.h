// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies programs, several at a time.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/make_entry.h"
#include "ncsim/setup/input.h"
#include "ncsim/simulation/check.h"

#include "check_options.h"
#include "result_cache.h"

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace ncsim::app {

class Checking {
public:
    /// All of them must outlive it. `cache` may be null.
    Checking(const CheckOptions& options, const simulation::Questions& questions,
             setup::InputSet& inputs, ResultCache* cache);

    /// Calls done(i, entry) in the order of the programs.
    void run(const std::vector<std::string>& programs,
             const std::function<void(std::size_t, report::Entry)>& done);

    /// The program of a page, of which there is but one.
    const report::Checked& looked_at() const { return looked_at_; }

private:
    report::Entry entry_for(const std::string& program, unsigned threads,
                            const std::stop_token& stop);
    report::Entry verified(const std::string& program, unsigned threads,
                           const std::stop_token& stop);

    const CheckOptions& options_;
    const simulation::Questions& questions_;
    setup::InputSet& inputs_;
    ResultCache* cache_;
    report::EntryOptions entry_options_;
    report::Checked looked_at_;
};

}  // namespace ncsim::app
