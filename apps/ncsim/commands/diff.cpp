// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares two programs or jobs.
#include "commands/diff.h"

#include "ncsim/report/describe.h"
#include "ncsim/report/difference.h"
#include "ncsim/report/review_page.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/compare_parts.h"
#include "ncsim/simulation/models.h"
#include "ncsim/simulation/plan_reader.h"
#include "ncsim/simulation/review_data.h"

#include "options/job_steps.h"
#include "options/option_row.h"
#include "options/plan_options.h"
#include "system/console.h"
#include "system/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ncsim::app {

namespace {

using DiffArgs = DiffOptions;

using Side = simulation::SurveyedPlan;

// Program to compare, with the set-up.
struct Input {
    DiffOptions options;
    std::string label;  ///< "set-up 2, back"; empty outside a job.
};

// Reads the program of `input`. If `stock` has a value, the program cuts this stock.
Side read_side(const Input& input, const std::optional<toolpath::Stock>& stock,
               setup::InputSet& inputs) {
    DiffOptions options = input.options;
    const bool is_later = options.job_step.value_or(0) > 0;
    if (stock) (is_later ? options.left_stock : options.stock) = stock;
    Side side;
    side.plan = plan_for(options, options, inputs);
    if (const auto machine = simulation::machine_for(options.machine, side.plan.job, inputs))
        (void)simulation::apply_machine(side.plan, *machine);
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

// Returns the programs of a job, or the program outside a job.
std::vector<Input> inputs_to_compare(const DiffOptions& options, setup::InputSet& inputs) {
    std::vector<Input> programs;
    for (const ChosenStep& step : chosen_steps(options, inputs)) {
        Input& one = programs.emplace_back(Input{options, step.label});
        one.options.job_step = step.number;
    }
    if (programs.empty()) programs.push_back({options, {}});
    return programs;
}

// Returns the options of the new side. A new program is in the set-up of the old program.
DiffOptions options_of_new(const DiffOptions& old) {
    if (!setup::is_job_file(old.new_program)) {
        DiffOptions options = old;
        options.program = old.new_program;
        if (old.job.empty() || !old.program.empty()) return options;
        setup::InputSet aside;
        const std::vector<ChosenStep> steps = chosen_steps(old, aside);
        if (steps.size() > 1) {
            throw std::runtime_error(
                fmt::format("'{}' has several programs; select the one that '{}' replaces: --setup",
                            old.job, old.new_program));
        }
        if (!steps.empty()) options.job_step = steps[0].number;
        return options;
    }
    return old.of_new_job ? *old.of_new_job : old;
}

// Compares the parts of two programs, which both cut the stock of the old program. Without --html,
// the review has the difference only. No value if a program cannot be cut.
std::optional<simulation::Review> review_of(const Input& a_input, const Input& b_input,
                                            setup::InputSet& inputs) {
    const Side a = read_side(a_input, {}, inputs);
    if (!is_usable(a)) return std::nullopt;
    const Side b_alone = read_side(b_input, {}, inputs);
    const toolpath::Stock stock = static_cast<const toolpath::Stock&>(*a.survey.stock);
    const Side b = read_side(b_input, stock, inputs);
    if (!is_usable(b)) return std::nullopt;

    simulation::Review review;
    if (a_input.options.html.empty()) {
        review.difference = simulation::compare_parts(a, b);
    } else {
        review = simulation::review_of(a, b, simulation::compare_with_parts(a, b));
    }
    report::Difference& d = review.difference;
    // An assumed stock follows from the motions and has no further information.
    const auto& other = b_alone.survey.stock;
    const bool both_specified = other && other->specified_by != toolpath::ValueSource::Assumption &&
                                a.survey.stock->specified_by != toolpath::ValueSource::Assumption;
    if (both_specified && !(*other == stock)) {
        d.stocks = fmt::format("the stocks differ: {} and {}; both were cut from the first",
                               report::describe(stock), report::describe(*other));
    }
    const double tolerance = a_input.options.tolerance_mm3;
    d.set_up = a_input.label;
    d.old_name = a.plan.job.program.name;
    d.new_name = b.plan.job.program.name;
    d.tolerance_mm3 = tolerance;
    d.differs =
        !d.stocks.empty() || d.only_old.volume_mm3 > tolerance || d.only_new.volume_mm3 > tolerance;
    return review;
}

}  // namespace

namespace {

constexpr OptionRow<DiffArgs> kComparedPrograms[] = {
    {"old", "OLD", kWork, "NC program, or job file (.toml)", store<&DiffArgs::program>, kRequired},
    {"new", "NEW", kWork, "NC program, or job file (.toml)", store<&DiffArgs::new_program>,
     kRequired}};

constexpr OptionRow<DiffArgs> kComparisonRows[] = {
    {"--tol", "MM3", kResult, "Permitted difference on each side, mm3 [0]",
     store<&DiffArgs::tolerance_mm3>, within(0.0, 1e15)},
    {"--process", "", kResult, "Compare feeds, speeds, coolant, tools and dwells, too",
     store<&DiffArgs::process>}};

constexpr OptionRow<DiffArgs> kDiffOutputs[] = {
    {"--json", "FILE", kWork, "Differences, JSON", store<&DiffArgs::json>},
    {"--html", "FILE", kWork, "Review: both parts, values, lines side by side",
     store<&DiffArgs::html>},
    {"--quiet,-q", "", kText, "Print nothing", store<&DiffArgs::quiet>}};

}  // namespace

void add_options(cli::App& diff, DiffOptions& o) {
    add_rows(diff, "", kComparedPrograms, o);
    add_language_options(diff, o);
    add_setup_options(diff, o);
    add_rows(diff, "Comparison", kComparisonRows, o);
    add_rows(diff, "Outputs", kDiffOutputs, o);
    add_report_unit(diff, o);
    add_simulation_options(diff, o, Models::Verifying);
}

void complete(DiffOptions& o) {
    require_verifying(o);
    if (setup::is_job_file(o.new_program) && !setup::is_job_file(o.program))
        throw Refusal{fmt::format("'{}' is a job, '{}' is not; expected OLD as a job, too",
                                  o.new_program, o.program)};
    take_job(o, o.program);
    require_job_of_set_up(o);
}

int run(const DiffOptions& options) {
    setup::InputSet inputs(inputs_of(options));
    OutputSet outputs(inputs);
    inputs.expect(options.new_program);
    outputs.reserve(options.json);
    outputs.reserve(options.html);
    const std::vector<Input> a = inputs_to_compare(options, inputs);
    const std::vector<Input> b = inputs_to_compare(options_of_new(options), inputs);
    if (a.size() != b.size()) {
        throw std::runtime_error(fmt::format(
            "'{}' has {} programs and '{}' has {}; expected two jobs with as many set-ups and "
            "programs",
            options.job, a.size(), options.new_program, b.size()));
    }
    std::vector<simulation::Review> reviews;
    std::vector<report::Difference> differences;
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::optional<simulation::Review> review = review_of(a[i], b[i], inputs);
        if (!review) return kEnvironment;  // 1 is a difference
        if (!options.quiet) {
            put_text(report::text_of(review->difference, options.report_unit),
                     outputs.takes_standard_output());
        }
        differences.push_back(review->difference);
        reviews.push_back(*std::move(review));
    }
    outputs.write(options.html, [&](std::ostream& out) {
        report::write_review(out, reviews, options.report_unit);
    });
    outputs.write(options.json,
                  [&](std::ostream& out) { report::write_differences(out, differences); });
    outputs.commit();
    const bool differs = std::ranges::any_of(differences, [&](const report::Difference& d) {
        return d.differs || (options.process && d.process.differs());
    });
    return differs ? kFindings : kClean;
}

}  // namespace ncsim::app
