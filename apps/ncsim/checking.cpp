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

Checking::Checking(const CheckOptions& options, const simulation::Questions& questions,
                   setup::InputSet& inputs, ResultCache* cache)
    : options_(options), questions_(questions), inputs_(inputs), cache_(cache) {
    // What is kept serves all reports.
    const bool all = cache || !options.shard.empty();
    entry_options_.many = !questions.tools_are_meant;
    entry_options_.notes = options.notes;
    entry_options_.quiet = options.quiet;
    entry_options_.warnings_as_errors = options.warnings_as_errors;
    entry_options_.json = all || !options.json.empty();
    entry_options_.sarif = all || !options.sarif.empty();
    entry_options_.junit = all || !options.junit.empty();
    entry_options_.github = all || options.github;
    entry_options_.csv = !options.csv.empty();
    entry_options_.selection = options.selection;
}

void Checking::run(const std::vector<std::string>& programs,
                   const std::function<void(std::size_t, report::Entry)>& done) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const auto count = static_cast<unsigned>(programs.size());
    const unsigned jobs = std::min(count, options_.jobs > 0 ? options_.jobs : cores);
    // Many programs share the cores; a single one has them all.
    const unsigned threads = jobs > 1 ? 1 : options_.threads;
    std::vector<report::Entry> entries(programs.size());
    in_order(
        programs.size(), jobs,
        [&](std::size_t i, const std::stop_token& stop) {
            entries[i] = entry_for(programs[i], threads, stop);
        },
        [&](std::size_t i) { done(i, std::exchange(entries[i], {})); });
}

// Never throws but for want of memory for a few words.
report::Entry Checking::entry_for(const std::string& program, unsigned threads,
                                  const std::stop_token& stop) {
    report::Checked broken;
    broken.path = setup::name_of_input(program);
    try {
        return verified(program, threads, stop);
    } catch (const std::bad_alloc&) {
        broken.failure = "out of memory";
    } catch (const std::exception& e) {
        broken.failure = e.what();
    }
    return report::entry_of(broken, kEnvironment, entry_options_);
}

report::Entry Checking::verified(const std::string& program, unsigned threads,
                                 const std::stop_token& stop) {
    // What is not named by a path may be something else the next time.
    const bool may_be_known = cache_ && program != "-" && !questions_.look;
    if (may_be_known) {
        if (std::optional<report::Entry> known = cache_->find(program, inputs_)) return *known;
    }
    setup::RecordedInput read(inputs_);
    report::Checked checked;
    const int code = check_program(checked, program, options_, questions_, threads, read, stop);
    report::Entry entry = report::entry_of(checked, code, entry_options_);
    if (may_be_known) cache_->keep(program, entry, read);
    if (questions_.look) looked_at_ = std::move(checked);
    return entry;
}

}  // namespace ncsim::app
