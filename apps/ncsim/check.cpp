// SPDX-License-Identifier: GPL-3.0-or-later
#include "check.h"

#include "ncsim/report/check_json.h"
#include "ncsim/report/check_text.h"
#include "ncsim/report/junit.h"
#include "ncsim/report/ledger_csv.h"
#include "ncsim/report/make_entry.h"
#include "ncsim/report/page.h"
#include "ncsim/report/plain_text.h"
#include "ncsim/report/rules.h"
#include "ncsim/report/sarif.h"
#include "ncsim/report/shard.h"
#include "ncsim/report/version.h"
#include "ncsim/setup/digest.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/setup/mesh_file.h"
#include "ncsim/setup/recorded_input.h"

#include "check_program.h"
#include "console.h"
#include "in_order.h"
#include "output.h"
#include "program_list.h"
#include "result_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace ncsim::app {

namespace {

// Not proven stands between clean and faulty.
bool is_better(int a, int b) {
    const auto rank = [](int code) { return code == kNotProven ? 0.5 : code; };
    return rank(a) < rank(b);
}

int exit_code_of(const report::Entries& all, bool exit_zero) {
    int worst = kClean;
    all([&](const report::Entry& entry) { worst = std::max(worst, entry.code, is_better); });
    const bool judged = worst == kFindings || worst == kNotProven;
    return judged && exit_zero ? int{kClean} : worst;
}

/// What is told of each program while others are under way, and of all of them in the end.
class Teller {
public:
    Teller(bool github, const report::TextOptions& options, bool aside)
        : github_(github), options_(options), aside_(aside) {}

    void tell(const report::Entry& entry) const {
        if (github_) {
            put_out(entry.github);
        } else {
            put_text(entry.text, aside_);
        }
    }
    void sum_up(const report::Entries& all) const {
        put_text(report::summary_of(all, options_), aside_);
    }

private:
    bool github_;
    report::TextOptions options_;
    bool aside_;
};

// Verifies programs, several at a time.
class Checking {
public:
    Checking(const CheckOptions& options, const simulation::Questions& questions,
             setup::InputSet& inputs, ResultCache* cache)
        : options_(options), questions_(questions), inputs_(inputs), cache_(cache) {
        entry_options_.many = !questions.tools_are_meant;
        entry_options_.notes = options.notes;
        entry_options_.quiet = options.quiet;
        entry_options_.warnings_as_errors = options.warnings_as_errors;
        entry_options_.csv = !options.csv.empty();
        // What is kept serves all reports.
        const bool all = cache || !options.shard.empty();
        entry_options_.json = all || !options.json.empty();
        entry_options_.sarif = all || !options.sarif.empty();
        entry_options_.junit = all || !options.junit.empty();
        entry_options_.github = all || options.github;
        entry_options_.selection = options.selection;
    }

    /// Calls done(i, entry) in the order of the programs.
    void run(const std::vector<std::string>& programs,
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

    /// The program of a page, of which there is but one.
    const report::Checked& looked_at() const { return looked_at_; }

private:
    report::Entry entry_for(const std::string& program, unsigned threads,
                            const std::stop_token& stop) {
        // What is not named by a path may be something else the next time.
        const bool may_be_known = cache_ && program != "-" && !questions_.look;
        if (may_be_known) {
            if (std::optional<report::Entry> known = cache_->find(program)) return *known;
        }
        setup::RecordedInput read(inputs_);
        report::Checked checked;
        const int code = check_program(checked, program, options_, questions_, threads, read, stop);
        report::Entry entry = report::entry_of(checked, code, entry_options_);
        if (may_be_known) cache_->keep(program, entry, read);
        if (questions_.look) looked_at_ = std::move(checked);
        return entry;
    }

    const CheckOptions& options_;
    const simulation::Questions& questions_;
    setup::InputSet& inputs_;
    ResultCache* cache_;
    report::EntryOptions entry_options_;
    report::Checked looked_at_;
};

// All that decides verdicts beside the programs.
std::string common_key(const CheckOptions& options, const setup::RecordedInput& read) {
    std::string key = fmt::format("ncsim {}\n{}", report::kVersion, options.told);
    if (!options.csv.empty()) key += "csv\n";
    for (const auto& [file, digest] : read.files())
        key += file + '\n' + digest.value_or("") + '\n';
    return key;
}

std::string digest_of_list(const std::vector<std::string>& programs) {
    std::string all;
    for (const std::string& program : programs)
        all += program + '\n';
    return setup::digest_of(all);
}

// One shard of them: its result goes to a file, and its exit code tells of the machine alone.
int check_shard(const CheckOptions& options, const std::vector<std::string>& programs,
                const std::string& common, Checking& checking, OutputSet& outputs) {
    const ShardNumber& number = options.number;
    report::ShardHead head;
    head.list = digest_of_list(programs);
    head.options = setup::digest_of(common);
    head.shard = number.shard;
    head.of = number.of;
    head.programs = programs.size();
    std::error_code error;
    std::filesystem::create_directories(options.out, error);
    if (error) {
        throw std::runtime_error(
            fmt::format("cannot make the folder '{}': {}", options.out, error.message()));
    }
    const std::string path =
        (std::filesystem::path(options.out) / report::shard_file_name(number.shard, number.of))
            .string();
    const auto say_done = [&](std::size_t count, const char* what) {
        put_text(fmt::format("shard {} of {}: {} of {} programs {}: {}\n", number.shard, number.of,
                             count, programs.size(), what, report::shown_path(path)));
    };
    const std::vector<std::size_t> share = share_of(programs, number);
    if (!options.redo && report::has_head(path, head)) {
        say_done(share.size(), "were verified before");
        return kClean;
    }
    outputs.reserve(path);
    std::vector<std::string> mine;
    for (const std::size_t i : share)
        mine.push_back(programs[i]);
    std::vector<report::Placed> placed;
    checking.run(mine, [&](std::size_t i, report::Entry entry) {
        placed.push_back({share[i], std::move(entry)});
    });
    outputs.write(path, [&](std::ostream& out) { report::write_shard(out, head, placed); });
    outputs.commit();
    say_done(share.size(), "verified");
    return kClean;
}

}  // namespace

int run(CheckOptions options) {
    setup::InputSet inputs;
    OutputSet outputs(inputs);
    if (options.github) outputs.claim_standard_output("--github");
    for (const std::string& path : inputs_of(options))
        inputs.expect(path);
    for (const std::string& path : outputs_of(options))
        outputs.reserve(path);
    const std::vector<std::string> programs = programs_of(options, inputs);
    for (const std::string& program : programs) {
        if (std::ranges::find(options.programs, program) == options.programs.end())
            inputs.expect(program);
    }
    setup::RecordedInput read(inputs);
    simulation::Questions questions;
    if (!options.machine.empty())
        questions.machine = setup::read_machine_file(options.machine, read);
    std::optional<simulation::Design> design;
    if (!options.design.empty()) {
        design = simulation::Design{setup::name_of_input(options.design),
                                    setup::read_mesh_file(options.design, read),
                                    options.design_tolerance};
        questions.design = &*design;
    }
    questions.selection = options.selection;
    questions.dog_leg = options.dog_leg;
    questions.cut_free = options.cut_free;
    questions.air_cuts = options.air_cuts;
    questions.ledger = !options.csv.empty();
    questions.look = !options.html.empty();
    questions.warnings_as_errors = options.warnings_as_errors;
    // With a single program, all that the command line tells is meant for it.
    questions.tools_are_meant = programs.size() == 1;

    std::string common = common_key(options, read);
    if (questions.tools_are_meant) common += "one\n";
    std::optional<ResultCache> cache;
    if (!options.cache.empty()) {
        cache.emplace(options.cache, common,
                      [](const std::string& what) { say("ncsim: " + what + '\n'); });
    }
    Checking checking(options, questions, inputs, cache ? &*cache : nullptr);
    if (!options.shard.empty()) return check_shard(options, programs, common, checking, outputs);

    const Teller teller(options.github, {options.notes, options.quiet, programs.size() > 1},
                        outputs.takes_standard_output());
    std::vector<report::Entry> entries;
    checking.run(programs, [&](std::size_t, report::Entry entry) {
        teller.tell(entry);
        entries.push_back(std::move(entry));
    });
    const report::Entries all = [&](const auto& take) { std::ranges::for_each(entries, take); };
    teller.sum_up(all);
    outputs.write(options.json, [&](std::ostream& out) { report::write_check_json(out, all); });
    outputs.write(options.sarif, [&](std::ostream& out) { report::write_sarif(out, all); });
    outputs.write(options.junit, [&](std::ostream& out) { report::write_junit(out, all); });
    outputs.write(options.csv, [&](std::ostream& out) { report::write_ledger_csv(out, all); });
    outputs.write(options.html,
                  [&](std::ostream& out) { report::write_page(out, checking.looked_at()); });
    outputs.commit();
    return exit_code_of(all, options.exit_zero);
}

int run(MergeOptions options) {
    setup::InputSet inputs;
    OutputSet outputs(inputs);
    if (options.github) outputs.claim_standard_output("--github");
    std::vector<std::string> files;
    for (const std::string& source : options.sources) {
        std::error_code error;
        if (!std::filesystem::is_directory(source, error)) {
            files.push_back(source);
            continue;
        }
        for (const auto& entry : std::filesystem::directory_iterator(source, error)) {
            if (entry.path().extension() == ".ndjson") files.push_back(entry.path().string());
        }
        if (error) {
            throw std::runtime_error(
                fmt::format("cannot read the folder '{}': {}", source, error.message()));
        }
    }
    for (const std::string& file : files)
        inputs.expect(file);
    for (const std::string& path : {options.json, options.sarif, options.junit})
        outputs.reserve(path);
    const report::Shards shards(files);
    const report::Entries all = shards.entries();
    const Teller teller(options.github, {options.notes, options.quiet, shards.programs() > 1},
                        outputs.takes_standard_output());
    all([&](const report::Entry& entry) { teller.tell(entry); });
    teller.sum_up(all);
    outputs.write(options.json, [&](std::ostream& out) { report::write_check_json(out, all); });
    outputs.write(options.sarif, [&](std::ostream& out) { report::write_sarif(out, all); });
    outputs.write(options.junit, [&](std::ostream& out) { report::write_junit(out, all); });
    outputs.commit();
    return exit_code_of(all, options.exit_zero);
}

int run(const RulesOptions& options) {
    if (options.json) {
        put_out(report::rules_json());
    } else {
        put_text(report::rules_text());
    }
    return kClean;
}

}  // namespace ncsim::app
