// SPDX-License-Identifier: GPL-3.0-or-later
#include "check.h"

#include "ncsim/report/annotations.h"
#include "ncsim/report/check_json.h"
#include "ncsim/report/check_text.h"
#include "ncsim/report/junit.h"
#include "ncsim/report/ledger_csv.h"
#include "ncsim/report/page.h"
#include "ncsim/report/rules.h"
#include "ncsim/report/sarif.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/setup/mesh_file.h"

#include "check_program.h"
#include "console.h"
#include "in_order.h"
#include "output.h"

#include <algorithm>
#include <optional>
#include <ostream>
#include <stop_token>
#include <thread>
#include <vector>

namespace ncsim::app {

namespace {

// Not proven stands between clean and faulty.
bool is_better(int a, int b) {
    const auto rank = [](int code) { return code == kNotProven ? 0.5 : code; };
    return rank(a) < rank(b);
}

}  // namespace

int run(CheckOptions options) {
    setup::InputSet inputs;
    OutputSet outputs(inputs);
    if (options.github) outputs.claim_standard_output("--github");
    for (const std::string& path : inputs_of(options))
        inputs.expect(path);
    for (const std::string& path : outputs_of(options))
        outputs.reserve(path);
    simulation::Questions questions;
    if (!options.machine.empty())
        questions.machine = setup::read_machine_file(options.machine, inputs);
    std::optional<simulation::Design> design;
    if (!options.design.empty()) {
        design = simulation::Design{setup::name_of_input(options.design),
                                    setup::read_mesh_file(options.design, inputs),
                                    options.design_tolerance};
        questions.design = &*design;
    }
    questions.selection = options.selection;
    questions.dog_leg = options.dog_leg;
    questions.cut_free = options.cut_free;
    questions.air_cuts = options.air_cuts;
    questions.ledger = !options.csv.empty();
    questions.look = !options.html.empty();
    questions.warnings_as_errors = options.warnings_as_errors;
    // With a single program, all that the command line tells is meant for it.
    questions.tools_are_meant = options.programs.size() == 1;
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const auto count = static_cast<unsigned>(options.programs.size());
    const unsigned jobs = std::min(count, options.jobs > 0 ? options.jobs : cores);
    // Many programs share the cores; a single one has them all.
    const unsigned threads = jobs > 1 ? 1 : options.threads;

    const report::TextOptions text{options.notes, options.quiet};
    const bool aside = outputs.takes_standard_output();
    std::vector<report::Checked> all(options.programs.size());
    std::vector<int> exit_codes(all.size(), kClean);
    in_order(
        all.size(), jobs,
        [&](std::size_t i, const std::stop_token& stop) {
            exit_codes[i] = check_program(all[i], options.programs[i], options, questions, threads,
                                          inputs, stop);
        },
        [&](std::size_t i) {
            if (options.github) {
                put_out(report::github_annotations(all[i]));
            } else {
                put_text(report::text_of(all[i], text), aside);
            }
        });
    if (!options.quiet && all.size() > 1) put_text(report::summary_of(all), aside);

    outputs.write(options.json, [&](std::ostream& out) { report::write_check_json(out, all); });
    outputs.write(options.sarif, [&](std::ostream& out) { report::write_sarif(out, all); });
    outputs.write(options.junit, [&](std::ostream& out) {
        report::write_junit(out, all, options.selection, options.warnings_as_errors);
    });
    outputs.write(options.csv, [&](std::ostream& out) { report::write_ledger_csv(out, all); });
    outputs.write(options.html, [&](std::ostream& out) { report::write_page(out, all.front()); });
    outputs.commit();

    int worst = kClean;
    for (const int code : exit_codes)
        worst = std::max(worst, code, is_better);
    const bool judged = worst == kFindings || worst == kNotProven;
    return judged && options.exit_zero ? int{kClean} : worst;
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
