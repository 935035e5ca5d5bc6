// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options for outputs of verdicts.
#include "options/report_options.h"

namespace ncsim::app {

void add_report_options(cli::App& command, ReportOptions& o) {
    command.begin_group("Reports");
    command.add_option("--json", o.json, "Verdicts, findings and doubts, JSON")->type_name("FILE");
    command.add_option("--sarif", o.sarif, "Findings and doubts, SARIF 2.1.0")->type_name("FILE");
    command.add_option("--junit", o.junit, "Suite per program, case per rule, JUnit XML")
        ->type_name("FILE");
    command
        .add_option("--write-baseline", o.write_baseline,
                    "Findings of this run as known ones, for --baseline")
        ->type_name("FILE");
    command.add_flag("--github", o.github, "Findings as annotations of GitHub Actions");
    command.add_flag("--exit-zero", o.exit_zero, "Exit with 0 despite findings and doubts");
    command.add_flag("--notes", o.notes, "Print notes, too");
    command.add_flag("--quiet,-q", o.quiet, "Print findings and doubts only");
}

std::vector<std::string> outputs_of(const ReportOptions& o) {
    std::vector<std::string> paths;
    for (const std::string* path : {&o.json, &o.sarif, &o.junit, &o.write_baseline}) {
        if (!path->empty()) paths.push_back(*path);
    }
    return paths;
}

}  // namespace ncsim::app
