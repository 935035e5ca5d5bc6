// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies programs on threads or in processes.
#include "check/checking.h"

#include "ncsim/report/file_digests.h"

#include "check/check_program.h"
#include "system/interruption.h"
#include "system/ordered_work.h"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace ncsim::app {

namespace {

// Returns the time limit (s) of a process: longer than the program's own limit, so the program can
// report that its time ran out.
double process_deadline(double max_seconds) {
    return max_seconds > 0.0 ? 2.0 * max_seconds + 1.0 : 0.0;
}

bool is_a_crash(int signal) {
    return signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGILL ||
           signal == SIGABRT;
}

std::string stopped_by_signal() {
    return fmt::format("stopped by {}", Interruption::name());
}

}  // namespace

std::size_t Checking::run(const std::vector<std::size_t>& which, const Done& done,
                          const Noted& noted) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const auto count = static_cast<unsigned>(which.size());
    const unsigned jobs = std::min(count, options_.jobs > 0 ? options_.jobs : cores);
    // Many programs share the cores; a single program uses all of them.
    const unsigned threads = jobs > 1 ? 1 : options_.threads;
    if (options_.isolate) return run_isolated(which, jobs, threads, done, noted);

    std::stop_source stop;
    std::optional<InterruptionScope> watch;
    if (Interruption::descriptor() >= 0) watch.emplace([stop]() mutable { stop.request_stop(); });
    std::vector<report::Entry> entries(which.size());
    return run_in_order(
        which.size(), jobs,
        [&](std::size_t i, const std::stop_token& asked) {
            entries[i] = verified(which[i], threads, asked);
        },
        [&](std::size_t i) { done(which[i], std::exchange(entries[i], {})); }, noted, stop);
}

// Programs with a known verdict need no process.
std::size_t Checking::run_isolated(const std::vector<std::size_t>& which, unsigned jobs,
                                   unsigned threads, const Done& done, const Noted& noted) {
    std::vector<std::optional<report::Entry>> entries(which.size());
    ProcessWork pieces;
    pieces.is_needed = [&](std::size_t i) {
        entries[i] = known(which[i]);
        return !entries[i];
    };
    pieces.work = [&](std::size_t i) {
        const CheckResult result = checked_result(which[i], threads, {});
        std::string conflict;
        try {
            inputs_.check();
        } catch (const std::exception& e) {
            conflict = e.what();
        }
        return fmt::format("{}\n{}\n{}\n{}", report::line_of(result.entry),
                           report::line_of(result.files), result.knows_all ? 1 : 0, conflict);
    };
    pieces.seconds = [&](std::size_t i) {
        return process_deadline(settings_.of(which[i]).options.max_seconds);
    };
    pieces.done = [&](std::size_t i, const ProcessEnd& end) {
        if (!entries[i]) entries[i] = entry_of_end(which[i], end);
        done(which[i], *std::exchange(entries[i], std::nullopt));
    };
    pieces.noted = noted;
    pieces.stop_descriptor = Interruption::descriptor();
    return run_in_processes(which.size(), jobs, pieces);
}

report::Entry Checking::entry_of_end(std::size_t program, const ProcessEnd& end) {
    if (end.is_stopped) return failed(program, stopped_by_signal(), kEnvironment);
    if (end.is_late) {
        const double most = settings_.of(program).options.max_seconds;
        return failed(program, fmt::format("it takes longer than --max-time {:g}: killed", most),
                      kEnvironment);
    }
    if (is_a_crash(end.signal)) {
        return failed(program,
                      fmt::format("a bug of ours, please report it: its process was ended by "
                                  "signal {} ({})",
                                  end.signal, ::strsignal(end.signal)),
                      kInternalError);
    }
    if (end.signal != 0) {
        return failed(program,
                      fmt::format("its process was ended by signal {} ({}){}", end.signal,
                                  ::strsignal(end.signal),
                                  end.signal == SIGKILL ? ": perhaps memory ran out" : ""),
                      kEnvironment);
    }
    if (end.exit_code != 0) return failed(program, "out of memory", kEnvironment);

    // Lines: the entry, the files, whether the files are complete, an input that is also an output.
    std::istringstream output(end.output);
    std::string line, names, are_all, conflict;
    std::getline(output, line);
    std::getline(output, names);
    std::getline(output, are_all);
    std::getline(output, conflict, '\0');
    std::optional<report::Entry> entry = report::entry_from(line);
    std::optional<report::FileDigests> files = report::file_digests_from(names);
    if (!entry || !files) return failed(program, "its process said nothing", kInternalError);
    if (!conflict.empty()) throw std::runtime_error(conflict);
    for (const auto& [file, digest] : *files) {
        if (digest && file != "-") inputs_.expect(file);
    }
    CheckResult result{std::move(*entry), std::move(*files), are_all == "1"};
    keep(program, result);
    return std::move(result.entry);
}

report::Entry Checking::failed(std::size_t program, const std::string& why, int code) const {
    report::Checked broken;
    broken.path = setup::name_of_input(programs_[program]);
    broken.program = settings_.of(program).label;
    broken.failure = why;
    return report::entry_of(broken, code, settings_.of(program).entries);
}

report::Entry Checking::not_reached(std::size_t program) const {
    return failed(program, stopped_by_signal() + " before it was begun", kEnvironment);
}

std::optional<report::Entry> Checking::known(std::size_t program) const {
    const std::string& path = programs_[program];
    const CheckSettings& settings = settings_.of(program);
    // A program without a path may differ in the next run.
    if (!settings.cache || path == "-" || settings.verification_options.wants_page ||
        !options_.png.empty())
        return std::nullopt;
    return settings.cache->find(path, settings.key_of_program(path), inputs_);
}

void Checking::keep(std::size_t program, const CheckResult& found) const {
    const std::string& path = programs_[program];
    CheckSettings& settings = settings_.of(program);
    if (!settings.cache || path == "-" || settings.verification_options.wants_page ||
        !found.knows_all)
        return;
    settings.cache->keep(path, settings.key_of_program(path), found.entry, found.files);
}

report::Entry Checking::verified(std::size_t program, unsigned threads,
                                 const std::stop_token& stop) {
    try {
        if (std::optional<report::Entry> before = known(program)) return *std::move(before);
        CheckResult result = checked_result(program, threads, stop);
        keep(program, result);
        return std::move(result.entry);
    } catch (const std::bad_alloc&) {
        return failed(program, "out of memory", kEnvironment);
    } catch (const std::exception& e) {
        return failed(program, e.what(), kEnvironment);
    }
}

// Never throws, except if there is no memory for a message.
Checking::CheckResult Checking::checked_result(std::size_t program, unsigned threads,
                                               const std::stop_token& stop) {
    try {
        CheckSettings& settings = settings_.of(program);
        setup::RecordedInput read(inputs_);
        CheckResult result;
        std::size_t programs = 1;
        for (std::size_t number = 0; number < programs; ++number) {
            report::Checked checked;
            checked.settings = settings.project;
            checked.program = settings.label;
            const int code =
                check_program(checked, programs_[program], settings.options,
                              settings.verification_options, threads, read, stop, number, programs);
            if (!checked.failure.empty() && stop.stop_requested() && Interruption::signal() != 0)
                checked.failure = stopped_by_signal();
            report::Entry entry = report::entry_of(checked, code, settings.entries);
            if (number == 0) {
                result.entry = std::move(entry);
            } else {
                result.entry.more.push_back(std::move(entry));
            }
            if ((settings.verification_options.wants_page || !options_.png.empty()) && shows_)
                shows_(program, std::move(checked));
        }
        result.files = read.files();
        result.knows_all = read.knows_all();
        for (const auto& [file, digest] : result.files) {
            if (digest && file.find('\n') == std::string::npos && file != programs_[program])
                result.entry.reads += file + '\n';
        }
        return result;
    } catch (const std::bad_alloc&) {
        return {failed(program, "out of memory", kEnvironment), {}, false};
    } catch (const std::exception& e) {
        return {failed(program, e.what(), kEnvironment), {}, false};
    }
}

}  // namespace ncsim::app
