// SPDX-License-Identifier: GPL-3.0-or-later
//
// Material in A that is not in B is what the cells of B find in A, one after another; so the
// other program is run on the finished part, measured, and its ledger names the lines.
#include "diff.h"

#include "ncsim/cda/tree.h"
#include "ncsim/verify/verifier.h"

#include "check_outputs.h"
#include "findings.h"
#include "job.h"
#include "output.h"
#include "pipeline.h"
#include "plain_text.h"
#include "sheet.h"
#include "survey.h"
#include "version.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace ncsim::app {

namespace {

struct Side {
    Job job;
    Survey survey;
};

Side read_side(const DiffOptions& diff, const std::string& path,
               const std::optional<toolpath::Stock>& stock, InputSet& inputs) {
    Options options;
    static_cast<ProgramOptions&>(options) = static_cast<const ProgramOptions&>(diff);
    static_cast<SimulationOptions&>(options) = static_cast<const SimulationOptions&>(diff);
    options.program = path;
    options.model = "cda";
    if (stock) options.stock = stock;
    Side side;
    side.job = read_job(std::move(options), inputs);
    side.survey = survey(side.job);
    return side;
}

// What of a motion the part can tell.
struct Trace {
    explicit Trace(const gcode::Motion& m)
        : what(m.what), kind(m.kind), tool(m.tool), known(m.known_start) {}
    decltype(gcode::Motion::what) what;
    gcode::MoveKind kind;
    int tool;
    gcode::KnownAxes known;
    bool operator==(const Trace&) const = default;
};

bool moves_alike(const Side& a, const Side& b) {
    const auto same_tool = [](const auto& s, const auto& t) {
        return s.first == t.first && s.second.tool == t.second.tool;
    };
    if (!std::ranges::equal(a.survey.tools, b.survey.tools, same_tool)) return false;
    std::vector<Trace> traces;
    gcode::interpret(a.job.program, a.job.interpreter, [&](const gcode::Motion& m) {
        if (gcode::start_of(m)) traces.emplace_back(m);
    });
    std::size_t next = 0;
    bool same = true;
    gcode::interpret(b.job.program, b.job.interpreter, [&](const gcode::Motion& m) {
        if (!gcode::start_of(m) || !same) return;
        same = next < traces.size() && traces[next] == Trace(m);
        ++next;
    });
    return same && next == traces.size();
}

const cda::TreeCda& tree_of(const Simulation& simulation) {
    return dynamic_cast<const cda::TreeCda&>(*simulation.part);
}

// What `side` still takes away from the finished `part`.
OneSided remainder(const Side& side, const Simulation& other) {
    verify::Setup setup;
    setup.ledger = true;
    for (const verify::RuleInfo& rule : verify::rules())
        setup.selection.ignored.emplace(rule.id);
    for (const auto& [number, used] : side.survey.tools)
        setup.tools[number].tool = used.tool;
    verify::Verifier verifier(setup, side.survey.stock->box, other.lattice);
    Verification verification;
    verification.verifier = &verifier;
    verification.start = &tree_of(other);
    const Simulation cut = simulate(side.job, side.survey, verification, {});
    const verify::Verdict verdict =
        verifier.finish(side.survey.interpretation, &tree_of(cut), cut.stock_volume);
    OneSided result;
    result.regions = verify::regions_of(verdict.ledger);
    result.volume_mm3 = verdict.ledger.removed_mm3;
    result.files = verdict.files;
    return result;
}

Difference difference(const Side& a, const Side& b) {
    Difference d;
    const Simulation made_a = simulate(a.job, a.survey, {}, {});
    d.old_mm3 = made_a.part_volume;
    d.same_motions = moves_alike(a, b);
    if (d.same_motions) {
        d.new_mm3 = d.old_mm3;
        return d;
    }
    const Simulation made_b = simulate(b.job, b.survey, {}, {});
    d.new_mm3 = made_b.part_volume;
    d.only_old = remainder(b, made_a);
    d.only_new = remainder(a, made_b);
    return d;
}

void put_side(std::string& text, const OneSided& side, const std::string& has,
              const std::string& cuts) {
    constexpr std::size_t kShown = 10;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "only in {}: {:.6g} mm3\n", has, side.volume_mm3);
    for (std::size_t i = 0; i < side.regions.size() && i < kShown; ++i) {
        const verify::Region& r = side.regions[i];
        fmt::format_to(out, "  {:.6g} mm3, cut by {}:{}\n    within {}\n", r.volume_mm3, cuts,
                       lines_text(r.lines), describe(r.box));
    }
    if (side.regions.size() > kShown) {
        fmt::format_to(out, "  and {} smaller regions\n", side.regions.size() - kShown);
    }
}

std::string text_of(const Difference& d, const DiffOptions& o, bool differs) {
    std::string text;
    auto out = std::back_inserter(text);
    const std::string old_name = shown_path(name_of_input(o.program));
    const std::string new_name = shown_path(name_of_input(o.new_program));
    if (!d.stocks.empty()) fmt::format_to(out, "{}\n", one_line(d.stocks));
    if (d.same_motions) {
        text += "both programs make the same motions with the same tools\n";
    } else {
        put_side(text, d.only_old, old_name, new_name);
        put_side(text, d.only_new, new_name, old_name);
    }
    fmt::format_to(out, "{}: {:.6g} mm3; {}: {:.6g} mm3: {}\n", old_name, d.old_mm3, new_name,
                   d.new_mm3, differs ? "the parts differ" : "the same part");
    return text;
}

using Json = nlohmann::ordered_json;

double tidy(double value) {
    return std::round(value * 1e6) / 1e6 + 0.0;
}

Json to_json(cda::Vec3 v) {
    return Json::array({tidy(v.x), tidy(v.y), tidy(v.z)});
}

Json to_json(const OneSided& side, const std::string& cut_by) {
    Json json{{"volume_mm3", tidy(side.volume_mm3)}, {"regions", Json::array()}};
    for (const verify::Region& r : side.regions) {
        Json lines = Json::array();
        for (const verify::LineRange& range : r.lines) {
            const bool main = range.file == 0 || range.file >= side.files.size();
            lines.push_back({{"file", main ? relative_path(cut_by) : side.files[range.file]},
                             {"first", range.first},
                             {"last", range.last}});
        }
        json["regions"].push_back(
            {{"volume_mm3", tidy(r.volume_mm3)},
             {"box", {{"min", to_json(r.box.min)}, {"max", to_json(r.box.max)}}},
             {"lines", std::move(lines)}});
    }
    return json;
}

void write_json(std::ostream& out, const Difference& d, const DiffOptions& o, bool differs) {
    Json json{{"version", 1},
              {"ncsim", kVersion},
              {"old", relative_path(name_of_input(o.program))},
              {"new", relative_path(name_of_input(o.new_program))},
              {"differs", differs},
              {"tolerance_mm3", o.tolerance_mm3},
              {"same_motions", d.same_motions},
              {"old_mm3", tidy(d.old_mm3)},
              {"new_mm3", tidy(d.new_mm3)},
              {"only_in_old", to_json(d.only_old, name_of_input(o.new_program))},
              {"only_in_new", to_json(d.only_new, name_of_input(o.program))}};
    if (!d.stocks.empty()) json["stocks"] = d.stocks;
    out << to_text(json);
}

// Programs that cannot be cut cannot be compared: says why.
bool is_usable(const Side& side) {
    if (side.survey.is_ready() && !gcode::has_errors(side.survey.diagnostics)) return true;
    print_findings(side.job.program, side.survey.diagnostics);
    return false;
}

}  // namespace

CLI::App* add_diff(CLI::App& app, DiffOptions& o) {
    CLI::App* diff =
        app.add_subcommand("diff", "Compare the parts of two programs: exit code 1 if they differ");
    diff->add_option("old", o.program, "NC program")->required()->type_name("OLD");
    diff->add_option("new", o.new_program, "NC program")->required()->type_name("NEW");
    add_language_options(*diff, o);
    add_setup_options(*diff, o);
    add_simulation_options(*diff, o);
    diff->add_option("--tol", o.tolerance_mm3, "Volume that may differ on each side, mm3 [0]")
        ->type_name("MM3")
        ->check(CLI::NonNegativeNumber);
    diff->add_option("--json", o.json, "The difference, JSON")->type_name("FILE");
    diff->add_flag("--quiet,-q", o.quiet, "Only the exit code");
    return diff;
}

void complete(const DiffOptions& o) {
    if (!o.save_job.empty()) throw Refusal{"--save-job: ncsim run and ncsim tools write job files"};
    if (!o.model.empty() && o.model != "cda") {
        throw Refusal{"--model: parts are compared with the model cda"};
    }
}

int run(const DiffOptions& options) {
    InputSet inputs;
    OutputSet outputs(inputs);
    for (const std::string& path : inputs_of(options))
        inputs.expect(path);
    inputs.expect(options.new_program);
    outputs.reserve(options.json);
    const Side a = read_side(options, options.program, {}, inputs);
    if (!is_usable(a)) return kFindings;
    const Side b_alone = read_side(options, options.new_program, {}, inputs);
    const toolpath::Stock stock = static_cast<const toolpath::Stock&>(*a.survey.stock);
    const Side b = read_side(options, options.new_program, stock, inputs);
    if (!is_usable(b)) return kFindings;

    Difference d = difference(a, b);
    // A stock that nobody told follows from the motions and says nothing of its own.
    const auto& other = b_alone.survey.stock;
    const bool both_told = other && other->told_by != toolpath::ToldBy::Assumption &&
                           a.survey.stock->told_by != toolpath::ToldBy::Assumption;
    if (both_told && !(*other == stock)) {
        d.stocks = fmt::format("the blocks differ: {} and {}; both were cut from the first",
                               describe(stock), describe(*other));
    }
    const bool differs = !d.stocks.empty() || d.only_old.volume_mm3 > options.tolerance_mm3 ||
                         d.only_new.volume_mm3 > options.tolerance_mm3;
    if (!options.quiet) put_text(text_of(d, options, differs), outputs.takes_standard_output());
    outputs.write(options.json, [&](std::ostream& out) { write_json(out, d, options, differs); });
    outputs.commit();
    return differs ? kFindings : kClean;
}

}  // namespace ncsim::app
