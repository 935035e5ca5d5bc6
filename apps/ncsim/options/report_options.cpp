// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options for outputs of verdicts.
#include "options/report_options.h"

namespace ncsim::app {

void add_report_options(cli::App& command, ReportOptions& o) {
    command.add_option("--json", o.json, "All there is to say, JSON")->type_name("FILE");
    command.add_option("--sarif", o.sarif, "Findings for code hosting, SARIF 2.1.0")
        ->type_name("FILE");
    command.add_option("--junit", o.junit, "A suite a program, a case a rule, JUnit XML")
        ->type_name("FILE");
    command
        .add_option("--write-baseline", o.write_baseline,
                    "What is found now, as known findings for --baseline")
        ->type_name("FILE");
    command.add_flag("--github", o.github, "Findings as annotations of GitHub Actions");
    command.add_flag("--exit-zero", o.exit_zero, "Exit code 0 whatever was found");
    command.add_flag("--notes", o.notes, "Show notes, too");
    command.add_flag("--quiet,-q", o.quiet, "Only findings, no verdicts and no summary");
}

std::vector<std::string> outputs_of(const ReportOptions& o) {
    std::vector<std::string> paths;
    for (const std::string* path : {&o.json, &o.sarif, &o.junit, &o.write_baseline}) {
        if (!path->empty()) paths.push_back(*path);
    }
    return paths;
}

}  // namespace ncsim::app
