// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options for outputs of verdicts.
#include "options/report_options.h"

namespace ncsim::app {

namespace {

constexpr OptionRow<ReportOptions> kReportRows[] = {
    {"--json", "FILE", "Outputs", kWork, "Verdicts, findings and doubts, JSON",
     store<&ReportOptions::json>},
    {"--sarif", "FILE", "Outputs", kWork, "Findings and doubts, SARIF 2.1.0",
     store<&ReportOptions::sarif>},
    {"--junit", "FILE", "Outputs", kWork, "Suite per program, case per rule, JUnit XML",
     store<&ReportOptions::junit>},
    {"--write-baseline", "FILE", "Outputs", kWork,
     "Findings of this run as known ones, for --baseline", store<&ReportOptions::write_baseline>},
    {"--github", "", "Outputs", kWork, "Findings as annotations of GitHub Actions",
     store<&ReportOptions::github>},
    {"--exit-zero", "", "Outputs", kWork, "Exit with 0 despite findings and doubts",
     store<&ReportOptions::exit_zero>},
    {"--notes", "", "Outputs", kText, "Print notes, too", store<&ReportOptions::notes>},
    {"--quiet,-q", "", "Outputs", kText, "Print findings and doubts only",
     store<&ReportOptions::quiet>}};

}  // namespace

std::span<const OptionRow<ReportOptions>> report_options() {
    return kReportRows;
}

std::vector<std::string> outputs_of(const ReportOptions& o) {
    std::vector<std::string> paths;
    for (const std::string* path : {&o.json, &o.sarif, &o.junit, &o.write_baseline}) {
        if (!path->empty()) paths.push_back(*path);
    }
    return paths;
}

}  // namespace ncsim::app
