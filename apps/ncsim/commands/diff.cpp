// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares two programs.
#include "commands/diff.h"

#include "ncsim/report/describe.h"
#include "ncsim/report/difference.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/compare_parts.h"
#include "ncsim/simulation/models.h"

#include "options/plan_options.h"
#include "system/console.h"
#include "system/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace ncsim::app {

namespace {

using Side = simulation::SurveyedPlan;

Side read_side(const DiffOptions& diff, const std::string& path,
               const std::optional<toolpath::Stock>& stock, setup::InputSet& inputs) {
    auto options = static_cast<const ProgramOptions&>(diff);
    options.program = path;
    if (stock) options.stock = stock;
    Side side;
    side.plan = plan_for(options, diff, diff.machine, inputs);
    if (!diff.machine.empty())
        simulation::apply_machine(side.plan, setup::read_machine(diff.machine, inputs));
    if (side.plan.model.empty()) side.plan.model = simulation::verifying_model().name;
    side.survey = simulation::survey(side.plan);
    return side;
}

// True if the program can be cut, which a comparison needs; otherwise prints the reasons.
bool is_usable(const Side& side) {
    if (side.survey.is_ready() && !gcode::has_errors(side.survey.diagnostics)) return true;
    print_findings(side.plan.job.program, side.survey.diagnostics);
    return false;
}

}  // namespace

cli::App* add_diff(cli::App& app, DiffOptions& o) {
    cli::App* diff =
        app.add_subcommand("diff", "Compare the parts of two programs: exit code 1 if they differ");
    diff->add_option("old", o.program, "NC program")->required()->type_name("OLD");
    diff->add_option("new", o.new_program, "NC program")->required()->type_name("NEW");
    add_language_options(*diff, o);
    add_setup_options(*diff, o);
    add_simulation_options(*diff, o, Models::Verifying);
    diff->begin_group("Machine");
    diff->add_option("--machine", o.machine,
                     "Machine: TOML, URDF, LinuxCNC INI, FreeCAD .fcm, Fusion")
        ->type_name("FILE");
    diff->begin_group("Comparison");
    diff->add_option("--tol", o.tolerance_mm3, "Permitted difference on each side, mm3 [0]")
        ->type_name("MM3")
        ->number_range(0.0, 1e15);
    diff->add_flag("--process", o.process, "Compare feeds, speeds, coolant, tools and dwells, too");
    diff->add_option("--json", o.json, "Differences, JSON")->type_name("FILE");
    diff->add_flag("--quiet,-q", o.quiet, "Print nothing");
    return diff;
}

void complete(const DiffOptions& o) {
    if (!o.save_job.empty()) throw Refusal{"--save-job: ncsim run and ncsim tools write job files"};
    require_verifying(o);
}

int run(const DiffOptions& options) {
    setup::InputSet inputs;
    OutputSet outputs(inputs);
    for (const std::string& path : inputs_of(options))
        inputs.expect(path);
    inputs.expect(options.new_program);
    if (!options.machine.empty()) inputs.expect(options.machine);
    outputs.reserve(options.json);
    const Side a = read_side(options, options.program, {}, inputs);
    if (!is_usable(a)) return kFindings;
    const Side b_alone = read_side(options, options.new_program, {}, inputs);
    const toolpath::Stock stock = static_cast<const toolpath::Stock&>(*a.survey.stock);
    const Side b = read_side(options, options.new_program, stock, inputs);
    if (!is_usable(b)) return kFindings;

    report::Difference d = simulation::compare_parts(a, b);
    // An assumed stock follows from the motions and has no information of its own.
    const auto& other = b_alone.survey.stock;
    const bool both_specified = other && other->specified_by != toolpath::ValueSource::Assumption &&
                                a.survey.stock->specified_by != toolpath::ValueSource::Assumption;
    if (both_specified && !(*other == stock)) {
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
    return differs || (options.process && d.process.differs()) ? kFindings : kClean;
}

}  // namespace ncsim::app
