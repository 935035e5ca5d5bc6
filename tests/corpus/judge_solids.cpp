// SPDX-License-Identifier: GPL-3.0-or-later
//
// judge_solids PATH [--judge READ_STEP] [--largest BYTES] [--seconds N] [--solid-seconds N] [--only
// TEXT] [--draft]: makes the solid for CAD of a program, or of every program of a folder, and
// prints a line per program that leaves a solid, then sums. A line has the verdict of
// ncsim_read_step (OpenCASCADE); whether all feed moves are lines along Z, level lines and level
// arcs ("simple"); faces and bytes of the STEP of true surfaces and of the STEP of facets; the
// facets that are kept; and the seconds of processor time for the cut and for the solid, with the
// cuts that refine the solid.
//
// Each program runs in a separate process with 4 GB. Processor time is limited to --seconds (60)
// for the cut, and to --solid-seconds (twice as much) each for the solid and for the judge.
// Programs are cut like `ncsim run` by default. If ncsim refuses a program, values are guessed as
// in a draft; with --draft all programs are cut as drafts. Exit code 1 if a solid is not valid, if
// ncsim fails on a program, or if there is no solid.
#include "ncsim/brep/measure.h"
#include "ncsim/export/step.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/job.h"
#include "ncsim/simulation/draft.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"

#include "entries.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace ncsim;

enum class Outcome : std::uint8_t { Solid, Nothing, Refused, TooSlow, Failed };

struct Made {
    Outcome outcome = Outcome::Failed;
    bool is_simple = true;
    std::uint64_t facet_faces = 0, facet_bytes = 0;  ///< For the solid of facets alone.
    std::uint64_t faces = 0, bytes = 0;
    std::uint64_t facets_kept = 0;
    double cut_s = 0.0, solid_s = 0.0;  ///< Processor time.
    std::array<char, 200> why{};

    void say(const std::string& text) {
        const std::size_t length = std::min(text.size(), why.size() - 1);
        std::copy_n(text.begin(), length, why.begin());
        why[length] = '\0';
        std::ranges::replace(why, '\n', ' ');
    }
};

struct Options {
    std::filesystem::path path;
    std::string judge, only;
    std::uintmax_t largest = ~std::uintmax_t{0};
    unsigned seconds = 60, solid_seconds = 0;
    bool is_draft = false;
};

bool is_turned(const gcode::Position& p) {
    return p.a != gcode::Angle{} || p.b != gcode::Angle{} || p.c != gcode::Angle{};
}

// True if the motion is no feed move, or has rotary axes at 0 and is level or along Z.
bool is_simple(const gcode::Motion& motion) {
    if (motion.kind != gcode::MoveKind::Feed) return true;
    const gcode::Position *from = gcode::start_of(motion), *to = gcode::end_of(motion);
    if (from && to && (is_turned(*from) || is_turned(*to))) return false;
    if (const auto* line = std::get_if<gcode::Linear>(&motion.action)) {
        const bool is_upright = line->from.x == line->to.x && line->from.y == line->to.y;
        return is_upright || line->from.z == line->to.z;
    }
    if (const auto* arc = std::get_if<gcode::Arc>(&motion.action))
        return arc->plane == gcode::Plane::XY && !arc->tilted && arc->from.z == arc->to.z;
    return !std::holds_alternative<gcode::Spline>(motion.action);
}

std::string step_of(const brep::Part& part, const mesh::Provenance& provenance) {
    std::ostringstream out;
    exporter::write_step_solid(out, part, provenance);
    return out.str();
}

double seconds_used() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Writes the solid to `step` and the values that the judge is to find to an adjacent file. Passes
// the result so far to `has_cut` as soon as the part is cut.
template <typename HasCut>
Made make(const std::string& path, const std::filesystem::path& step, bool is_draft,
          const HasCut& has_cut) {
    setup::InputSet inputs;
    setup::JobOptions options;
    options.program = path;
    simulation::Plan plan;
    plan.job = setup::read_job(options, inputs);
    plan.threads = 1;
    plan.draft = is_draft;
    plan.keep_boundary = true;
    simulation::Survey survey = simulation::survey(plan);
    if (!survey.is_ready() && !is_draft) {
        plan.draft = true;
        survey = simulation::survey(plan);
    }
    Made made;
    made.outcome = Outcome::Nothing;
    if (!survey.is_ready() || survey.is_flat()) {
        made.say(survey.is_flat() ? "Z is never set" : simulation::reason_not_simulated(survey));
        return made;
    }
    if (is_draft) simulation::coarsen(plan, survey, false, false);
    gcode::interpret(plan.job.program, plan.job.interpreter, [&](const gcode::Motion& motion) {
        made.is_simple = made.is_simple && is_simple(motion);
    });
    simulation::Verification nothing;
    nothing.keep_cuts = true;
    const double begin = seconds_used();
    const simulation::Simulation milled = simulation::simulate(plan, survey, nothing, {});
    made.cut_s = seconds_used() - begin;
    if (milled.boundary->faces.empty()) {
        made.say("nothing is left");
        return made;
    }
    made.outcome = Outcome::TooSlow;
    made.say("its solid is too slow");
    has_cut(made);
    const brep::Part facets = exporter::flat_solid(*milled.boundary, exporter::kStepTolerance).part;
    made.facet_faces = facets.faces.size();
    if (facets.faces.size() <= exporter::kStepMaxFaces)
        made.facet_bytes = step_of(facets, milled.provenance).size();
    const double start = seconds_used();
    const simulation::Solid solid =
        simulation::refined_solid(plan, survey, milled, exporter::kStepTolerance, {});
    made.solid_s = seconds_used() - start;
    const brep::Part& part = solid.recognised.part;
    if (part.faces.size() > exporter::kStepMaxFaces) {
        made.outcome = Outcome::Refused;
        made.say("it has more faces than a file is to have");
        return made;
    }
    const std::string text = step_of(part, solid.provenance);
    made.faces = part.faces.size();
    made.facets_kept = solid.recognised.facets_kept;
    made.bytes = text.size();
    std::ofstream(step, std::ios::binary) << text;
    std::size_t shells = 0;
    for (const brep::Solid& one : part.solids)
        shells += 1 + one.voids.size();
    constexpr double kIntegrals = 1e-6;
    std::ofstream(std::filesystem::path(step).replace_extension(".expect"))
        << "solids -" << shells << "\nvolume " << std::to_string(brep::volume(part)) << "\nmoved "
        << kIntegrals + std::max(part.miss_mm, part.facet_miss_mm) << '\n';
    made.outcome = Outcome::Solid;
    made.say("");
    return made;
}

void limit(int what, rlim_t now, rlim_t later) {
    const rlimit limits{now, later};
    ::setrlimit(what, &limits);
}

// Limits processor time to `now` seconds, at most raised to `later` seconds, and limits memory.
void limit_all(unsigned now, unsigned later) {
    constexpr rlim_t kMemory = 4'000'000'000;
    limit(RLIMIT_CPU, now, later);
    limit(RLIMIT_AS, kMemory, kMemory);
    limit(RLIMIT_CORE, 0, 0);
}

// True if the limit of processor time ended the process. If both limits are equal, either signal is
// possible.
bool took_too_long(int status) {
    return WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
}

// Makes the solid in a separate process.
Made make_apart(const std::string& path, const std::filesystem::path& step, const Options& o) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    std::fflush(stdout);
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        ::close(ends[0]);
        const unsigned in_all = o.seconds + o.solid_seconds;
        limit_all(o.seconds, in_all);
        const auto tell = [&](const Made& made) {
            return ::write(ends[1], &made, sizeof made) == static_cast<ssize_t>(sizeof made);
        };
        const auto has_cut = [&](const Made& made) {
            limit(RLIMIT_CPU, in_all, in_all);
            tell(made);
        };
        Made made;
        try {
            made = make(path, step, o.is_draft, has_cut);
        } catch (const std::exception& e) {
            made = {};
            made.say(e.what());
        }
        ::_exit(tell(made) ? 0 : 1);
    }
    ::close(ends[1]);
    // The last result that the process sent counts.
    Made made, specified;
    bool is_there = false;
    while (::read(ends[0], &specified, sizeof specified) ==
           static_cast<ssize_t>(sizeof specified)) {
        made = specified;
        is_there = true;
    }
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    const bool has_ended = is_there && made.outcome != Outcome::TooSlow;
    if (!has_ended && !(is_there && took_too_long(status))) {
        made = {};
        if (took_too_long(status)) made.outcome = Outcome::TooSlow;
        made.say(took_too_long(status) ? "too slow" : "it came down");
    }
    return made;
}

// Returns the message of the judge about the file; empty if the solid is valid.
std::string judged(const std::string& judge, const std::filesystem::path& step, unsigned seconds,
                   bool& has_judged) {
    const std::filesystem::path said = std::filesystem::path(step).replace_extension(".said");
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        limit_all(seconds, seconds);
        const int to = ::open(said.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
        ::dup2(to, STDERR_FILENO);
        const int nowhere = ::open("/dev/null", O_WRONLY);
        ::dup2(nowhere, STDOUT_FILENO);
        ::execl(judge.c_str(), judge.c_str(), step.c_str(), nullptr);
        ::_exit(127);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    has_judged = !took_too_long(status);
    if (!has_judged || (WIFEXITED(status) && WEXITSTATUS(status) == 0)) return {};
    std::string text = corpus::read_file(said);
    std::erase(text, '\n');
    for (auto at = text.find(step.string()); at != std::string::npos; at = text.find(step.string()))
        text.erase(at, step.string().size());
    return text.empty() ? "the judge came down" : text;
}

// Sums over a kind of programs.
struct Sum {
    int solids = 0, whole = 0;
    double cut_s = 0.0, solid_s = 0.0;
    void add(const Made& made) {
        ++solids;
        if (made.facets_kept == 0) ++whole;
        cut_s += made.cut_s;
        solid_s += made.solid_s;
    }
    void print(const char* name) const {
        if (solids == 0) return;
        std::printf("%s: %d of %d without facets, %.1f %%; cuts %.1f s, solids %.1f s\n", name,
                    whole, solids, 100.0 * whole / solids, cut_s, solid_s);
    }
};

template <typename Of>
std::uint64_t median_of(const std::vector<Made>& all, const Of& of) {
    std::vector<std::uint64_t> values;
    for (const Made& made : all)
        values.push_back(of(made));
    std::ranges::nth_element(values,
                             values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

// Prints a line per program, then the sums. Returns true if all solids are valid, ncsim never
// fails, and there is a solid.
bool judge_all(const Options& o, const std::filesystem::path& folder) {
    const std::filesystem::path step = folder / "part.step";
    std::vector<Made> all;
    Sum of_all, of_simple;
    int valid = 0, invalid = 0, not_judged = 0, failed = 0, slow = 0, refused = 0;
    std::printf("%-10s %-7s %9s %9s %9s %9s %9s %7s %7s  program\n", "judged", "moves", "faces",
                "bytes", "of facets", "bytes", "kept", "cut s", "solid s");
    for (const corpus::Entry& entry : corpus::entries_of(o.path)) {
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(entry.path, error);
        if (error || size > o.largest || entry.name.find(o.only) == std::string::npos) continue;
        const Made made = make_apart(entry.path.string(), step, o);
        if (made.outcome == Outcome::Nothing) continue;
        if (made.outcome != Outcome::Solid) {
            const bool is_slow = made.outcome == Outcome::TooSlow;
            const bool is_refused = made.outcome == Outcome::Refused;
            ++(is_slow ? slow : is_refused ? refused : failed);
            std::printf("%-10s %s: %s\n",
                        is_slow      ? "too slow"
                        : is_refused ? "refused"
                                     : "FAILED",
                        entry.name.c_str(), made.why.data());
            continue;
        }
        all.push_back(made);
        of_all.add(made);
        if (made.is_simple) of_simple.add(made);
        std::string fault;
        const char* verdict = "-";
        if (!o.judge.empty()) {
            bool has_judged = false;
            fault = judged(o.judge, step, o.solid_seconds, has_judged);
            verdict = !has_judged ? "not judged" : fault.empty() ? "valid" : "INVALID";
            ++(!has_judged ? not_judged : fault.empty() ? valid : invalid);
        }
        std::printf("%-10s %-7s %9llu %9llu %9llu %9llu %9llu %7.2f %7.2f  %s%s%s\n", verdict,
                    made.is_simple ? "simple" : "other",
                    static_cast<unsigned long long>(made.faces),
                    static_cast<unsigned long long>(made.bytes),
                    static_cast<unsigned long long>(made.facet_faces),
                    static_cast<unsigned long long>(made.facet_bytes),
                    static_cast<unsigned long long>(made.facets_kept), made.cut_s, made.solid_s,
                    entry.name.c_str(), fault.empty() ? "" : ": ", fault.c_str());
        std::fflush(stdout);
    }
    std::printf("\n");
    of_all.print("all");
    of_simple.print("simple");
    if (!all.empty()) {
        const auto median = [&](auto of) {
            return static_cast<unsigned long long>(median_of(all, of));
        };
        std::printf("medians: %llu faces of facets, %llu faces; %llu bytes, %llu bytes\n",
                    median([](const Made& m) { return m.facet_faces; }),
                    median([](const Made& m) { return m.faces; }),
                    median([](const Made& m) { return m.facet_bytes; }),
                    median([](const Made& m) { return m.bytes; }));
    }
    std::printf("%d valid, %d invalid, %d not judged; %d too slow, %d refused, %d failed\n", valid,
                invalid, not_judged, slow, refused, failed);
    return invalid == 0 && failed == 0 && !all.empty();
}

}  // namespace

int main(int argc, char** argv) {
    Options o;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const bool has_value = i + 1 < argc;
        if (word == "--judge" && has_value) {
            o.judge = argv[++i];
        } else if (word == "--largest" && has_value) {
            o.largest = std::strtoull(argv[++i], nullptr, 10);
        } else if (word == "--seconds" && has_value) {
            o.seconds = static_cast<unsigned>(std::strtoul(argv[++i], nullptr, 10));
        } else if (word == "--solid-seconds" && has_value) {
            o.solid_seconds = static_cast<unsigned>(std::strtoul(argv[++i], nullptr, 10));
        } else if (word == "--only" && has_value) {
            o.only = argv[++i];
        } else if (word == "--draft") {
            o.is_draft = true;
        } else if (o.path.empty() && !word.starts_with('-')) {
            o.path = word;
        } else {
            o.path.clear();
            break;
        }
    }
    if (o.path.empty() || o.seconds == 0) {
        std::fprintf(stderr,
                     "usage: judge_solids PATH [--judge READ_STEP] [--largest BYTES] "
                     "[--seconds N] [--solid-seconds N] [--only TEXT] [--draft]\n");
        return 2;
    }
    if (o.solid_seconds == 0) o.solid_seconds = 2 * o.seconds;
    std::string folder = (std::filesystem::temp_directory_path() / "judge_solids.XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr) {
        std::fprintf(stderr, "judge_solids: no folder for files\n");
        return 2;
    }
    int code = 2;
    try {
        code = judge_all(o, folder) ? 0 : 1;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "judge_solids: %s\n", e.what());
    }
    std::error_code nothing;
    std::filesystem::remove_all(folder, nothing);
    return code;
}
