// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies programs and writes the reports.
#include "check/check_command.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/export/png.h"
#include "ncsim/report/ledger_csv.h"
#include "ncsim/report/rule_list.h"
#include "ncsim/report/shard.h"
#include "ncsim/setup/digest.h"
#include "ncsim/setup/recorded_input.h"
#include "ncsim/verify/doubt.h"
#include "ncsim/verify/rule.h"

#include "check/check_settings.h"
#include "check/check_tile.h"
#include "check/checking.h"
#include "check/finding_picture.h"
#include "check/pages.h"
#include "check/program_list.h"
#include "check/reports.h"
#include "options/suggestion.h"
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
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
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

// Verifies one shard. The result goes to a file, and the exit code reports environment failures
// only.
int check_shard(const CheckOptions& options, const ProgramList& list, const std::string& key,
                Checking& checking, OutputSet& outputs) {
    const std::vector<std::string>& programs = list.programs;
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
                             count, programs.size(), what, printable_path(path)));
    };
    const std::vector<std::size_t> share = share_of(programs, number);
    if (report::is_whole(path, head)) {
        say_done(share.size(), "were verified before");
        return kClean;
    }
    outputs.reserve(path);
    std::vector<report::Placed> placed;
    Progress progress(share.size(), shows_progress(options), "programs");
    checking.run(
        share,
        [&](std::size_t i, report::Entry entry) {
            entry.is_subprogram = list.is_subprogram[i];
            placed.push_back({i, std::move(entry)});
        },
        [&](std::size_t done) { progress.update(done); });
    progress.hide();
    outputs.write(
        path, [&](std::ostream& out) { report::write_shard(out, head, list.excluded, placed); });
    outputs.commit();
    say_done(share.size(), "verified");
    return kClean;
}

// Judges the programs of a list, then the subprograms that no program calls.
class Judgement {
public:
    Judgement(const CheckOptions& options, const ProgramList& list, Checking& checking,
              const Reports& reports)
        : list_(list),
          checking_(checking),
          reports_(reports),
          is_github_(options.github),
          progress_(list.programs.size(), shows_progress(options), "programs") {}

    void run() {
        std::vector<std::size_t> programs, subprograms;
        for (std::size_t i = 0; i < list_.programs.size(); ++i)
            (list_.is_subprogram[i] ? subprograms : programs).push_back(i);
        check(programs, [&](std::size_t, const report::Entry& entry) {
            report::for_each_program(entry, [&](const report::Entry& one) {
                print_entry(one);
                programs_.push_back(one);
            });
        });
        if (!subprograms.empty()) check_uncalled(subprograms);
        progress_.hide();
    }

    // Returns all entries, called or not: the programs, then the subprograms.
    report::Entries listed() const {
        return [this](const auto& each) {
            std::ranges::for_each(programs_, each);
            std::ranges::for_each(subprograms_, each);
        };
    }
    void print_subprograms(const report::Entries& all) {
        all([&](const report::Entry& entry) {
            if (entry.is_subprogram) print_entry(entry);
        });
    }
    std::size_t not_begun() const { return not_begun_; }

private:
    template <class Done>
    void check(const std::vector<std::size_t>& which, const Done& done) {
        const std::size_t before = finished_;
        const std::size_t begun = checking_.run(
            which,
            [&](std::size_t i, report::Entry entry) {
                entry.is_subprogram = list_.is_subprogram[i];
                done(i, std::move(entry));
            },
            [&](std::size_t count) { progress_.update(finished_ = before + count); });
        for (std::size_t i = begun; i < which.size(); ++i) {
            report::Entry entry = checking_.not_reached(which[i]);
            entry.is_subprogram = list_.is_subprogram[which[i]];
            done(which[i], std::move(entry));
        }
        not_begun_ += which.size() - begun;
    }

    void check_uncalled(const std::vector<std::size_t>& subprograms) {
        std::map<std::string, std::size_t> places;
        for (const std::size_t i : subprograms) {
            report::Entry entry;
            entry.path = list_.programs[i];
            entry.is_subprogram = true;
            places.emplace(entry.path, subprograms_.size());
            subprograms_.push_back(std::move(entry));
        }
        std::set<std::string> called;
        for (const report::CalledFile& file : report::called_files(listed()))
            called.insert(file.path);
        std::vector<std::size_t> uncalled;
        for (const std::size_t i : subprograms) {
            if (!called.contains(list_.programs[i])) uncalled.push_back(i);
        }
        check(uncalled, [&](std::size_t i, report::Entry entry) {
            entry.more.clear();  // A file that only returns has one program.
            subprograms_[places.at(list_.programs[i])] = std::move(entry);
        });
    }

    void print_entry(const report::Entry& entry) {
        const bool says = !(is_github_ ? entry.github : entry.text).empty();
        if (says) progress_.hide();
        reports_.add(entry);
        if (says) progress_.draw(finished_);
    }

    const ProgramList& list_;
    Checking& checking_;
    const Reports& reports_;
    bool is_github_;
    Progress progress_;
    std::size_t finished_ = 0;
    std::size_t not_begun_ = 0;
    std::vector<report::Entry> programs_, subprograms_;
};

}  // namespace

namespace {

constexpr const char* kNoPicture =
    "--png: no picture, because there is not exactly one program with a verdict";

// Returns what a picture needs.
report::Checked verdict_of(const report::Checked& checked) {
    report::Checked verdict;
    verdict.path = checked.path;
    verdict.failure = checked.failure;
    verdict.word = checked.word;
    verdict.verdict = checked.verdict;
    return verdict;
}

}  // namespace

int run(CheckOptions options) {
    if (!options.tile.empty()) return check_tile(std::move(options));
    setup::InputSet inputs(inputs_of(options));
    OutputSet outputs(inputs);
    if (options.github) outputs.claim_standard_output("--github");
    // The list is made before the outputs are opened, because a folder of programs may contain
    // temporary files of outputs.
    const ProgramList list = programs_of(options, inputs);
    for (const std::string& path : outputs_of(options)) {
        if (path != options.html) outputs.reserve(path);
    }
    const std::vector<std::string>& programs = list.programs;
    for (const std::string& program : programs) {
        // A job may not name a FIFO, which could block.
        std::error_code ignored;
        const bool is_of_job = !options.steps.empty();
        if (is_of_job && !std::filesystem::is_regular_file(program, ignored)) continue;
        if (std::ranges::find(options.programs, program) == options.programs.end())
            inputs.expect(program);
    }
    setup::RecordedInput recorded(inputs);
    setup::InputSet& read = options.tiles ? recorded : inputs;
    SettingsOfPrograms settings(options, programs, read);
    print_error(settings.notes());
    print_error(settings.lost_programs());
    if (options.tiles) settings.of(0).verification_options.tiles = options.tiles;
    Checking checking(options, programs, settings, read);
    if (!options.shard.empty())
        return check_shard(options, list, settings.key(), checking, outputs);

    const Interruption interruption;
    Pages pages(options, programs, outputs);
    std::optional<report::Checked> judged;  // for --png
    checking.show([&](std::size_t i, report::Checked checked) {
        if (!options.png.empty()) judged = verdict_of(checked);
        pages.add(i, std::move(checked));
    });
    const Reports reports(options, outputs, programs.size() > 1);
    Judgement judgement(options, list, checking, reports);
    judgement.run();
    if (options.tiles) expect_same_files(options.tile_files, recorded.files());
    const report::Entries listed = judgement.listed();
    const report::Scope scope{list.excluded, report::called_files(listed),
                              options.steps.empty() ? std::string() : options.job};
    const report::Entries all = report::remove_called(listed, scope.called);
    judgement.print_subprograms(all);
    reports.write(all, scope);
    outputs.write(options.csv, [&](std::ostream& out) {
        report::write_ledger_csv(out, all, options.report_unit);
    });
    if (Interruption::signal() == 0) pages.write(all, scope);
    if (Interruption::signal() == 0 && !options.png.empty()) {
        if (programs.size() != 1 || !judged) throw std::runtime_error(kNoPicture);
        outputs.write(options.png, [&](std::ostream& out) {
            exporter::write_png(out, finding_picture(programs[0], settings.of(0), *judged, read));
        });
    }
    outputs.commit();
    if (Interruption::signal() != 0) {
        print_error(fmt::format("ncsim: stopped by {}: {} of {} programs were not begun\n",
                                Interruption::name(), judgement.not_begun(), programs.size()));
        Interruption::raise_again();
        return kEnvironment;
    }
    return exit_code_of(all, options.exit_zero);
}

int run(const RulesOptions& options) {
    if (options.json) {
        write_stdout(report::rules_json());
        return kClean;
    }
    const std::string text =
        options.id.empty() ? report::rules_text() : report::rule_text(options.id);
    if (text.empty()) {
        std::vector<std::string> known;
        for (const verify::RuleInfo& rule : verify::rules()) {
            known.emplace_back(rule.id);
            known.emplace_back(verify::name_of(rule.category));
        }
        for (const verify::ReasonInfo& reason : verify::reasons())
            known.emplace_back(reason.id);
        const std::string meant = nearest(options.id, known);
        throw std::runtime_error(
            fmt::format("there is no rule, category or reason for doubt '{}'{}", options.id,
                        meant.empty() ? "" : fmt::format("; did you mean {}?", meant)));
    }
    put_text(text);
    return kClean;
}

}  // namespace ncsim::app
