// SPDX-License-Identifier: GPL-3.0-or-later
//
// Material in A that is not in B is what the cells of B find in A, one after another; so the
// other program is run on the finished part, measured, and its ledger names the lines.
#include "diff.h"

#include "ncsim/cda/tree.h"
#include "ncsim/report/describe.h"
#include "ncsim/report/difference.h"
#include "ncsim/verify/verifier.h"

#include "console.h"
#include "output.h"
#include "pipeline.h"
#include "plan_options.h"
#include "survey.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace ncsim::app {

namespace {

struct Side {
    Plan plan;
    Survey survey;
};

Side read_side(const DiffOptions& diff, const std::string& path,
               const std::optional<toolpath::Stock>& stock, setup::InputSet& inputs) {
    ProgramOptions options = diff;
    options.program = path;
    if (stock) options.stock = stock;
    Side side;
    side.plan = plan_for(options, diff, inputs);
    side.plan.model = "cda";
    side.survey = survey(side.plan);
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
    gcode::interpret(a.plan.job.program, a.plan.job.interpreter, [&](const gcode::Motion& m) {
        if (gcode::start_of(m)) traces.emplace_back(m);
    });
    std::size_t next = 0;
    bool same = true;
    gcode::interpret(b.plan.job.program, b.plan.job.interpreter, [&](const gcode::Motion& m) {
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
report::OneSided remainder(const Side& side, const Simulation& other) {
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
    const Simulation cut = simulate(side.plan, side.survey, verification, {});
    const verify::Verdict verdict =
        verifier.finish(side.survey.interpretation, &tree_of(cut), cut.stock_volume);
    report::OneSided result;
    result.regions = verify::regions_of(verdict.ledger);
    result.volume_mm3 = verdict.ledger.removed_mm3;
    result.files = verdict.files;
    return result;
}

report::Difference difference(const Side& a, const Side& b) {
    report::Difference d;
    const Simulation made_a = simulate(a.plan, a.survey, {}, {});
    d.old_mm3 = made_a.part_volume;
    d.same_motions = moves_alike(a, b);
    if (d.same_motions) {
        d.new_mm3 = d.old_mm3;
        return d;
    }
    const Simulation made_b = simulate(b.plan, b.survey, {}, {});
    d.new_mm3 = made_b.part_volume;
    d.only_old = remainder(b, made_a);
    d.only_new = remainder(a, made_b);
    return d;
}

// Programs that cannot be cut cannot be compared: says why.
bool is_usable(const Side& side) {
    if (side.survey.is_ready() && !gcode::has_errors(side.survey.diagnostics)) return true;
    print_findings(side.plan.job.program, side.survey.diagnostics);
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
    setup::InputSet inputs;
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

    report::Difference d = difference(a, b);
    // A stock that nobody told follows from the motions and says nothing of its own.
    const auto& other = b_alone.survey.stock;
    const bool both_told = other && other->told_by != toolpath::ToldBy::Assumption &&
                           a.survey.stock->told_by != toolpath::ToldBy::Assumption;
    if (both_told && !(*other == stock)) {
        d.stocks = fmt::format("the blocks differ: {} and {}; both were cut from the first",
                               report::describe(stock), report::describe(*other));
    }
    const bool differs = !d.stocks.empty() || d.only_old.volume_mm3 > options.tolerance_mm3 ||
                         d.only_new.volume_mm3 > options.tolerance_mm3;
    d.old_name = setup::name_of_input(options.program);
    d.new_name = setup::name_of_input(options.new_program);
    d.tolerance_mm3 = options.tolerance_mm3;
    d.differs = differs;
    if (!options.quiet) put_text(report::text_of(d), outputs.takes_standard_output());
    outputs.write(options.json, [&](std::ostream& out) { report::write_difference(out, d); });
    outputs.commit();
    return differs ? kFindings : kClean;
}

}  // namespace ncsim::app
