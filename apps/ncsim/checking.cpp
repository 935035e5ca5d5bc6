// SPDX-License-Identifier: GPL-3.0-or-later
#include "checking.h"

#include "ncsim/setup/recorded_input.h"

#include "check_program.h"
#include "in_order.h"

#include <algorithm>
#include <exception>
#include <new>
#include <optional>
#include <thread>
#include <utility>

namespace ncsim::app {

void Checking::run(const std::vector<std::size_t>& which,
                   const std::function<void(std::size_t, report::Entry)>& done) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const auto count = static_cast<unsigned>(which.size());
    const unsigned jobs = std::min(count, options_.jobs > 0 ? options_.jobs : cores);
    // Many programs share the cores; a single one has them all.
    const unsigned threads = jobs > 1 ? 1 : options_.threads;
    std::vector<report::Entry> entries(which.size());
    in_order(
        which.size(), jobs,
        [&](std::size_t i, const std::stop_token& stop) {
            entries[i] = entry_for(which[i], threads, stop);
        },
        [&](std::size_t i) { done(which[i], std::exchange(entries[i], {})); });
}

// Never throws but for want of memory for a few words.
report::Entry Checking::entry_for(std::size_t program, unsigned threads,
                                  const std::stop_token& stop) {
    report::Checked broken;
    broken.path = setup::name_of_input(programs_[program]);
    try {
        return verified(program, threads, stop);
    } catch (const std::bad_alloc&) {
        broken.failure = "out of memory";
    } catch (const std::exception& e) {
        broken.failure = e.what();
    }
    return report::entry_of(broken, kEnvironment, settings_.of(program).entries);
}

report::Entry Checking::verified(std::size_t program, unsigned threads,
                                 const std::stop_token& stop) {
    const std::string& path = programs_[program];
    CheckSettings& settings = settings_.of(program);
    // What is not named by a path may be something else the next time.
    const bool may_be_known = settings.cache && path != "-" && !settings.questions.look;
    const std::string about = settings.baseline ? settings.baseline->about(path) : "";
    if (may_be_known) {
        if (std::optional<report::Entry> known = settings.cache->find(path, about, inputs_))
            return *known;
    }
    setup::RecordedInput read(inputs_);
    report::Checked checked;
    checked.settings = settings.project;
    const int code =
        check_program(checked, path, settings.options, settings.questions, threads, read, stop);
    report::Entry entry = report::entry_of(checked, code, settings.entries);
    if (may_be_known) settings.cache->keep(path, about, entry, read);
    if (settings.questions.look) looked_at_ = std::move(checked);
    return entry;
}

}  // namespace ncsim::app
