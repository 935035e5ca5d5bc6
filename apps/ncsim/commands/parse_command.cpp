// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints the interpretation of a program.
#include "commands/parse_command.h"

#include "ncsim/gcode/control_codes.h"
#include "ncsim/gcode/parser.h"
#include "ncsim/report/listing.h"
#include "ncsim/setup/job.h"

#include "options/option_row.h"
#include "system/console.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

namespace ncsim::app {

namespace {

// Returns the row in the table of controls.
const gcode::ControlCodes* known_control(const char* option, const std::string& name) {
    if (const gcode::ControlCodes* control = gcode::find_control_codes(name)) return control;
    std::vector<std::string_view> names;
    for (const gcode::ControlCodes& control : gcode::all_control_codes())
        names.push_back(control.name);
    throw Refusal{fmt::format("{} '{}': expected {}", option, name, fmt::join(names, ", "))};
}

}  // namespace

void add_options(cli::App& parse, ParseOptions& o) {
    using P = ParseOptions;
    static constexpr OptionRow<P> kRows[] = {
        {"--canonical", "", kWork, "Motions, in mm and degrees", store<&P::canonical>},
        {"--for", "CONTROL", kWork, "Codes that this control does not have: grbl, haas, …",
         read<&P::control, known_control>, without("--canonical")},
        {"--json", "", kWork, "JSON, an object per line", store<&P::json>}};
    add_program_options(parse, o);
    add_rows(parse, "Outputs", kRows, o);
}

int run(const ParseOptions& options) {
    setup::InputSet inputs(inputs_of(options));
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
