// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/check.h"

#include "ncsim/report/ledger_csv.h"
#include "ncsim/report/page.h"
#include "ncsim/report/plain_text.h"
#include "ncsim/report/rules.h"
#include "ncsim/report/shard.h"
#include "ncsim/setup/digest.h"
#include "ncsim/setup/recorded_input.h"

#include "check/check_settings.h"
#include "check/check_tile.h"
#include "check/checking.h"
#include "check/program_list.h"
#include "check/reports.h"
#include "run/tile.h"
#include "system/console.h"
#include "system/interruption.h"
#include "system/output.h"
#include "system/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <numeric>
#include <ostream>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

namespace ncsim::app {

namespace {

std::string digest_of_list(const std::vector<std::string>& programs) {
    std::string all;
    for (const std::string& program : programs)
        all += program + '\n';
    return setup::digest_of(all);
}

bool shows_progress(const CheckOptions& options) {
    return !options.quiet && ::isatty(STDERR_FILENO) != 0;
}

// One shard of them: its result goes to a file, and its exit code tells of the machine alone.
int check_shard(const CheckOptions& options, const std::vector<std::string>& programs,
                const std::string& key, Checking& checking, OutputSet& outputs) {
    const ShardNumber& number = options.number;
    report::ShardHead head;
    head.list = digest_of_list(programs);
    head.options = setup::digest_of(key);
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
    std::vector<report::Placed> placed;
    Progress progress(share.size(), shows_progress(options), "programs");
    checking.run(
        share,
        [&](std::size_t i, report::Entry entry) {
            placed.push_back({i, std::move(entry)});
        },
        [&](std::size_t done) { progress.update(done); });
    progress.hide();
    outputs.write(path, [&](std::ostream& out) { report::write_shard(out, head, placed); });
    outputs.commit();
    say_done(share.size(), "verified");
    return kClean;
}

}  // namespace

int run(CheckOptions options) {
    if (!options.tile.empty()) return check_tile(std::move(options));
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
    setup::RecordedInput recorded(inputs);
    setup::InputSet& read = options.tiles ? recorded : inputs;
    SettingsOfPrograms settings(options, programs, read);
    say(settings.lost_programs());
    if (options.tiles) settings.of(0).questions.tiles = options.tiles;
    Checking checking(options, programs, settings, read);
    if (!options.shard.empty())
        return check_shard(options, programs, settings.key(), checking, outputs);

    const Interruption interruption;
    const Reports reports(options, outputs, programs.size() > 1);
    std::vector<std::size_t> every(programs.size());
    std::iota(every.begin(), every.end(), std::size_t{0});
    std::vector<report::Entry> entries;
    Progress progress(programs.size(), shows_progress(options), "programs");
    std::size_t finished = 0;
    const auto take = [&](report::Entry entry) {
        const bool says = !(options.github ? entry.github : entry.text).empty();
        if (says) progress.hide();
        reports.tell(entry);
        if (says) progress.draw(finished);
        entries.push_back(std::move(entry));
    };
    const std::size_t begun = checking.run(
        every, [&](std::size_t, report::Entry entry) { take(std::move(entry)); },
        [&](std::size_t done) { progress.update(finished = done); });
    if (options.tiles) expect_same_files(options.tile_files, recorded.files());
    for (std::size_t i = begun; i < programs.size(); ++i)
        take(checking.not_reached(i));
    progress.hide();
    const report::Entries all = [&](const auto& each) { std::ranges::for_each(entries, each); };
    reports.write(all);
    outputs.write(options.csv, [&](std::ostream& out) { report::write_ledger_csv(out, all); });
    if (Interruption::signal() == 0) {
        outputs.write(options.html,
                      [&](std::ostream& out) { report::write_page(out, checking.looked_at()); });
    }
    outputs.commit();
    if (Interruption::signal() != 0) {
        say(fmt::format("ncsim: stopped by {}: {} of {} programs were not begun\n",
                        Interruption::name(), programs.size() - begun, programs.size()));
        Interruption::pass_on();
        return kEnvironment;
    }
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
