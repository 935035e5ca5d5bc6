// SPDX-License-Identifier: GPL-3.0-or-later
//
// run_corpus DIR [--only TEXT] [--quiet]: runs the programs of a folder and prints whether each was
// read, was refused, agrees with its reference or differs. A table follows at the end.
//
// DIR/INDEX.tsv, if present, lists the programs (below DIR/programs), their kind, and the verdict
// of the reference interpreter ("ok": strict rules must agree; "ok-lenient": default rules must
// agree in geometry; "error": default rules should run the program). Otherwise default rules run
// every file below DIR that looks like a program. Exit code 1 if a program differs or takes too
// long.
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/subprogram_file.h"

#include "entries.h"
#include "reference.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>

namespace fs = std::filesystem;
using namespace ncsim;
using corpus::Entry;
using corpus::read_file;

namespace {

constexpr double kMostSeconds = 10.0;

/// Returns an O-file, under the names that controls look for, from the folder of the program, from
/// a folder below, or likewise from up to two parent folders.
std::optional<gcode::SourceFile> find_file(fs::path directory, const fs::path& top,
                                           std::string_view name) {
    const std::vector<std::string> tries = gcode::subprogram_files(name);
    std::error_code error;
    for (int level = 0; level < 3; ++level) {
        for (const std::string& file : tries) {
            if (fs::is_regular_file(directory / file, error)) {
                return gcode::SourceFile{file, read_file(directory / file)};
            }
        }
        for (const auto& entry : fs::recursive_directory_iterator(directory, error)) {
            if (std::ranges::find(tries, entry.path().filename().string()) != tries.end()) {
                return gcode::SourceFile{entry.path().filename().string(), read_file(entry.path())};
            }
        }
        if (directory == top || directory.parent_path() == top) break;
        directory = directory.parent_path();
    }
    return std::nullopt;
}

struct Tally {
    int programs = 0, agree = 0, differ = 0, read = 0, with_errors = 0, stopped = 0, refused = 0,
        lax = 0, slow = 0;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: run_corpus DIR [--only TEXT] [--quiet]\n");
        return 2;
    }
    const fs::path directory = argv[1];
    const char* only = nullptr;
    bool quiet = false;
    for (int i = 2; i < argc; ++i) {
        if (std::strcmp(argv[i], "--only") == 0 && i + 1 < argc) only = argv[++i];
        if (std::strcmp(argv[i], "--quiet") == 0) quiet = true;
    }
    std::map<std::string, Tally> table;
    bool clean = true;
    for (const Entry& entry : corpus::entries_of(directory)) {
        if (only && entry.name.find(only) == std::string::npos) continue;
        const gcode::SourceFile file{entry.name, read_file(entry.path)};
        gcode::InterpreterOptions options;
        options.strict = entry.status == "ok";
        options.work_offsets_specified.fill(true);  // all work offsets are 0
        // Settings of the reference machine.
        if (!entry.reference.empty()) {
            options.peck_clearance = 1.0;
            options.starts_with_g99 = true;
        }
        options.read_file = [&](std::string_view name) {
            return find_file(entry.path.parent_path(), directory / "programs", name);
        };
        std::vector<corpus::Event> events;
        const bool has_reference = !entry.reference.empty();
        const auto start = std::chrono::steady_clock::now();
        const gcode::Interpretation result =
            gcode::interpret(file, options, [&](const gcode::Motion& motion) {
                if (has_reference) events.push_back(corpus::to_event(motion, *motion.frame));
            });
        corpus::put_into_machine(events, result.workpiece);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

        Tally& tally = table[entry.status + " " + entry.kind];
        ++tally.programs;
        std::string verdict;
        std::string detail;
        const auto error = std::ranges::find(result.diagnostics, gcode::Severity::Error,
                                             &gcode::Diagnostic::severity);
        const bool has_error = error != result.diagnostics.end();
        if (result.refused) {
            verdict = "refused";
            ++tally.refused;
        } else if (has_reference) {
            std::optional<std::string> text = corpus::read_gzip(entry.reference.string());
            const std::vector<corpus::Event> expected = corpus::read_reference(text.value_or(""));
            const auto difference = corpus::compare(events, expected, entry.status != "ok");
            verdict = difference ? "differs" : "agrees";
            if (difference) detail = difference->text;
            ++(difference ? tally.differ : tally.agree);
            clean = clean && !difference;
        } else {
            // The program ran to its end with some blocks omitted, or stopped before its end.
            const bool stopped = has_error && (result.stopped || result.motions == 0);
            verdict = stopped ? "stopped" : has_error ? "errors" : "read";
            ++(stopped ? tally.stopped : has_error ? tally.with_errors : tally.read);
        }
        if (entry.status == "error") {
            // Strict rules should also refuse a program that the reference refused.
            options.strict = true;
            if (!gcode::has_errors(gcode::interpret(file, options, {}).diagnostics)) {
                ++tally.lax;
                detail += "strict rules accept what the reference refused";
            }
        }
        if (seconds > kMostSeconds) {
            verdict += " SLOW";
            ++tally.slow;
            clean = false;
        }
        if (has_error) {
            detail += (detail.empty() ? "" : " / ") + gcode::render(*error, {"", ""});
            while (!detail.empty() && detail.back() == '\n')
                detail.pop_back();
        }
        if (!quiet || verdict.starts_with("differs")) {
            std::printf("%-8s %-10s %-8s %s%s%s\n", verdict.c_str(), entry.status.c_str(),
                        entry.kind.c_str(), entry.name.c_str(), detail.empty() ? "" : "\n         ",
                        detail.c_str());
        }
    }
    std::printf("\n%-28s %8s %7s %7s %6s %7s %8s %8s %5s %6s\n", "reference, kind", "programs",
                "agree", "differ", "read", "errors", "stopped", "refused", "lax", "slow");
    Tally sum;
    for (const auto& [name, t] : table) {
        std::printf("%-28s %8d %7d %7d %6d %7d %8d %8d %5d %6d\n", name.c_str(), t.programs,
                    t.agree, t.differ, t.read, t.with_errors, t.stopped, t.refused, t.lax, t.slow);
        sum.programs += t.programs, sum.agree += t.agree, sum.differ += t.differ,
            sum.read += t.read;
        sum.with_errors += t.with_errors, sum.stopped += t.stopped, sum.refused += t.refused,
            sum.slow += t.slow, sum.lax += t.lax;
    }
    std::printf("%-28s %8d %7d %7d %6d %7d %8d %8d %5d %6d\n", "all", sum.programs, sum.agree,
                sum.differ, sum.read, sum.with_errors, sum.stopped, sum.refused, sum.lax, sum.slow);
    return clean ? 0 : 1;
}
