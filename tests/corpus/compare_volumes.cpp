// SPDX-License-Identifier: GPL-3.0-or-later
//
// compare_volumes PATH [--largest BYTES] [--seconds N] [--only TEXT] [--quiet] [--job FILE]
// [--machine FILE]: tests whether the volume by rays (--model dexel) is as near to the volume of
// the exact model as reported. PATH is a program, or a folder of programs. Each program runs in a
// separate process with N seconds of processor time (60) and 4 GB. Unspecified values are guessed,
// as in a draft. A table follows at the end. Exit code 1 if a volume is farther off than reported,
// if a model fails on a program, or if there is no program.
#include "ncsim/cda/boundary.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/job.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/draft.h"
#include "ncsim/simulation/simulate.h"

#include "entries.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace ncsim;

enum class Verdict : std::uint8_t { Within, Beyond, NothingCut, NotSimulated, Failed, TooSlow };
constexpr std::array kVerdicts{"within",        "BEYOND", "nothing cut",
                               "not simulated", "FAILED", "too slow"};

struct Comparison {
    Verdict verdict = Verdict::Failed;
    double exact = 0.0, off = 0.0;  ///< mm³; `off` is the excess of the volume by rays.
    /// Error that rays report, and volume that round tools may leave but the polygons of the exact
    /// model do not (mm³).
    double specified = 0.0, polygons = 0.0;
    std::array<char, 200> why{};

    void say(const std::string& text) {
        const std::size_t length = std::min(text.size(), why.size() - 1);
        std::copy_n(text.begin(), length, why.begin());
        why[length] = '\0';
        std::ranges::replace(why, '\n', ' ');
    }
    /// Returns the share of the permitted difference that is needed.
    double share() const { return std::abs(off) / std::max(specified + polygons, 1e-300); }
};

double longest_side(const Box& box) {
    return std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
}

// Returns the area (mm²) of the faces that tools cut.
double cut_area(cda::Boundary boundary) {
    std::erase_if(boundary.faces,
                  [](const cda::BoundaryFace& face) { return face.origin == cda::kStockOrigin; });
    return cda::area(boundary);
}

struct Specified {
    std::string job, machine;  ///< Paths of files; empty if there is none.
};

Comparison compare(const std::string& path, const Specified& files) {
    setup::InputSet inputs;
    setup::JobOptions options;
    options.program = path;
    options.job = files.job;
    simulation::Plan plan;
    plan.job = setup::read_job(options, inputs);
    if (!files.machine.empty())
        simulation::apply_machine(plan, setup::read_machine(files.machine, inputs));
    plan.threads = 1;
    plan.draft = true;
    plan.keep_boundary = true;
    const simulation::Survey survey = simulation::survey(plan);
    Comparison result;
    if (!survey.is_ready()) {
        result.verdict = Verdict::NotSimulated;
        result.say(simulation::reason_not_simulated(survey));
        return result;
    }
    // Chooses polygons that are too fine to hide the errors of rays.
    plan.tool_tolerance = std::max(0.01, longest_side(survey.stock->box) / 20'000.0);
    const simulation::Simulation exact = simulation::simulate(plan, survey, {}, {});
    double tool_error = 0.0;
    for (const auto& [number, facts] : exact.cutters)
        tool_error = std::max(tool_error, facts.error_mm);
    result.polygons = tool_error * cut_area(*exact.boundary);
    plan.model = "dexel";
    plan.keep_boundary = false;
    simulation::choose_rays(plan, survey);
    simulation::choose_resolution(plan, survey);
    const simulation::Simulation rays = simulation::simulate(plan, survey, {}, {});
    result.exact = exact.part_volume;
    result.off = rays.part_volume - exact.part_volume;
    result.specified = rays.part_volume_error;
    // Sums of doubles may be off by 1e-12.
    const double rounding = 1e-12 * exact.stock_volume;
    result.verdict = !(std::abs(result.off) <= result.specified + result.polygons + rounding)
                         ? Verdict::Beyond
                     : exact.part_volume == exact.stock_volume ? Verdict::NothingCut
                                                               : Verdict::Within;
    return result;
}

void limit(int what, rlim_t most) {
    const rlimit limits{most, most};
    ::setrlimit(what, &limits);
}

// Compares in a separate process.
Comparison compare_apart(const std::string& path, const Specified& files, unsigned seconds) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    std::fflush(stdout);
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        ::close(ends[0]);
        limit(RLIMIT_CPU, seconds);
        limit(RLIMIT_AS, rlim_t{4'000'000'000});
        limit(RLIMIT_CORE, 0);
        Comparison result;
        try {
            result = compare(path, files);
        } catch (const std::exception& e) {
            result.say(e.what());
        }
        const auto written = ::write(ends[1], &result, sizeof result);
        ::_exit(written == static_cast<ssize_t>(sizeof result) ? 0 : 1);
    }
    ::close(ends[1]);
    Comparison result;
    const bool is_there =
        ::read(ends[0], &result, sizeof result) == static_cast<ssize_t>(sizeof result);
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (!is_there) {
        result = {};
        const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        // The hard limit of processor time equals the soft limit, so either signal is possible.
        if (signal == SIGXCPU || signal == SIGKILL) result.verdict = Verdict::TooSlow;
        result.say("signal " + std::to_string(signal));
    }
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    std::filesystem::path path;
    Specified files;
    std::uintmax_t largest = ~std::uintmax_t{0};
    unsigned seconds = 60;
    std::string only;
    bool quiet = false;
    for (int i = 1; i < argc; ++i) {
        const bool has_value = i + 1 < argc;
        if (std::strcmp(argv[i], "--largest") == 0 && has_value) {
            largest = std::strtoull(argv[++i], nullptr, 10);
        } else if (std::strcmp(argv[i], "--seconds") == 0 && has_value) {
            seconds = static_cast<unsigned>(std::strtoul(argv[++i], nullptr, 10));
        } else if (std::strcmp(argv[i], "--only") == 0 && has_value) {
            only = argv[++i];
        } else if (std::strcmp(argv[i], "--quiet") == 0) {
            quiet = true;
        } else if (std::strcmp(argv[i], "--job") == 0 && has_value) {
            files.job = argv[++i];
        } else if (std::strcmp(argv[i], "--machine") == 0 && has_value) {
            files.machine = argv[++i];
        } else if (path.empty() && argv[i][0] != '-') {
            path = argv[i];
        } else {
            path.clear();
            break;
        }
    }
    if (path.empty() || seconds == 0) {
        std::fprintf(stderr,
                     "usage: compare_volumes PATH [--largest BYTES] [--seconds N] "
                     "[--only TEXT] [--quiet] [--job FILE] [--machine FILE]\n");
        return 2;
    }
    try {
        std::map<std::string, std::array<int, kVerdicts.size()>> table;
        // Counts programs by the share of the permitted difference that is needed: up to a tenth, a
        // quarter, a half, the whole.
        constexpr std::array kShares{0.1, 0.25, 0.5, 1.0};
        std::array<int, kShares.size()> shares{};
        bool is_clean = true;
        int programs = 0;
        for (const corpus::Entry& entry : corpus::entries_of(path)) {
            if (entry.name.find(only) == std::string::npos) continue;
            std::error_code error;
            const std::uintmax_t size = std::filesystem::file_size(entry.path, error);
            if (error || size > largest) continue;
            ++programs;
            const Comparison c = compare_apart(entry.path.string(), files, seconds);
            ++table[entry.kind][static_cast<std::size_t>(c.verdict)];
            is_clean &= c.verdict != Verdict::Beyond && c.verdict != Verdict::Failed;
            if (c.verdict == Verdict::Within) {
                const auto* place = std::ranges::lower_bound(kShares, c.share());
                ++shares[static_cast<std::size_t>(std::min(place, kShares.end() - 1) -
                                                  kShares.begin())];
            }
            const bool is_wrong = c.verdict == Verdict::Beyond || c.verdict == Verdict::Failed;
            if (quiet && !is_wrong) continue;
            std::printf("%-13s %s", kVerdicts[static_cast<std::size_t>(c.verdict)],
                        entry.name.c_str());
            if (c.why[0] != '\0') {
                std::printf(": %s\n", c.why.data());
            } else {
                std::printf(": %.1f mm3, by rays %+.4g, reported %.4g, polygons %.4g at most\n",
                            c.exact, c.off, c.specified, c.polygons);
            }
            std::fflush(stdout);
        }
        std::printf("\n%-14s", "kind");
        for (const char* name : kVerdicts)
            std::printf("%15s", name);
        for (const auto& [kind, counts] : table) {
            std::printf("\n%-14s", kind.c_str());
            for (const int count : counts)
                std::printf("%15d", count);
        }
        std::printf("\n%d programs; of what is allowed, those within needed", programs);
        for (std::size_t i = 0; i < shares.size(); ++i)
            std::printf("%s at most %g of it: %d", i == 0 ? "" : ",", kShares[i], shares[i]);
        std::printf("\n");
        // Without a comparison the result is not clean.
        if (programs == 0) is_clean = false;
        return is_clean ? 0 : 1;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "compare_volumes: %s\n", e.what());
        return 2;
    }
}
