// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints the interpretation of a program.
#include "commands/parse_command.h"

#include "ncsim/gcode/control_codes.h"
#include "ncsim/gcode/parser.h"
#include "ncsim/report/listing.h"
#include "ncsim/setup/job.h"

#include "system/console.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

namespace ncsim::app {

namespace {

// Returns the row in the table of controls.
const gcode::ControlCodes* known_control(const std::string& name) {
    if (const gcode::ControlCodes* control = gcode::find_control_codes(name)) return control;
    std::vector<std::string_view> names;
    for (const gcode::ControlCodes& control : gcode::all_control_codes())
        names.push_back(control.name);
    throw Refusal{fmt::format("--for '{}': expected {}", name, fmt::join(names, ", "))};
}

}  // namespace

cli::App* add_parse(cli::App& app, ParseOptions& options) {
    cli::App* parse = app.add_subcommand("parse", "Show how a program is read: blocks or motions");
    add_program_options(*parse, options);
    parse->begin_group("Outputs");
    parse->add_flag("--canonical", options.canonical, "Motions, in mm and degrees");
    parse
        ->add_option_function<std::string>(
            "--for", [&options](const std::string& name) { options.control = known_control(name); },
            "Codes that this control does not have: grbl, haas, …")
        ->type_name("CONTROL")
        ->excludes("--canonical");
    parse->add_flag("--json", options.json, "JSON, an object per line");
    return parse;
}

int run(const ParseOptions& options) {
    setup::InputSet inputs;
    for (const std::string& path : inputs_of(options))
        inputs.expect(path);
    const setup::Job job = setup::read_job(static_cast<const setup::JobOptions&>(options), inputs);
    if (options.control) {
        const report::MissingCodes found =
            report::list_missing_codes(job.program, *options.control, options.json, write_stdout);
        return found.lacking > 0 ? kFindings : found.unknown > 0 ? kNotProven : kClean;
    }
    gcode::ParserOptions parser;
    parser.strict = job.options.strict;
    const gcode::Diagnostics diagnostics =
        options.canonical
            ? report::list_motions(job.program, job.interpreter, options.json, write_stdout)
            : report::list_blocks(job.program, parser, options.json, write_stdout);
    print_findings(job.program, diagnostics);
    return gcode::has_errors(diagnostics) ? kFindings : kClean;
}

}  // namespace ncsim::app
