// SPDX-License-Identifier: GPL-3.0-or-later
#include "check.h"

#include "ncsim/report/ledger_csv.h"
#include "ncsim/report/page.h"
#include "ncsim/report/plain_text.h"
#include "ncsim/report/rules.h"
#include "ncsim/report/shard.h"
#include "ncsim/report/version.h"
#include "ncsim/setup/digest.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/setup/mesh_file.h"
#include "ncsim/setup/recorded_input.h"

#include "checking.h"
#include "console.h"
#include "output.h"
#include "program_list.h"
#include "reports.h"
#include "result_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

namespace ncsim::app {

namespace {

// All that decides verdicts beside the programs.
std::string common_key(const CheckOptions& options, const setup::RecordedInput& read) {
    std::string key = fmt::format("ncsim {}\n{}", report::kVersion, options.told);
    if (!options.csv.empty()) key += "csv\n";
    for (const auto& [file, digest] : read.files())
        key += named_anywhere(file) + '\n' + digest.value_or("") + '\n';
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
    if (!options.redo && report::is_whole(path, head)) {
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
    if (!options.machine.empty()) questions.machine = setup::read_machine(options.machine, read);
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

    const Reports reports(options, outputs, programs.size() > 1);
    std::vector<report::Entry> entries;
    checking.run(programs, [&](std::size_t, report::Entry entry) {
        reports.tell(entry);
        entries.push_back(std::move(entry));
    });
    const report::Entries all = [&](const auto& take) { std::ranges::for_each(entries, take); };
    reports.write(all);
    outputs.write(options.csv, [&](std::ostream& out) { report::write_ledger_csv(out, all); });
    outputs.write(options.html,
                  [&](std::ostream& out) { report::write_page(out, checking.looked_at()); });
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
