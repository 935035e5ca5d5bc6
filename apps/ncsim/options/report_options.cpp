// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options for outputs of verdicts.
#include "options/report_options.h"

namespace ncsim::app {

namespace {

using ReportArgs = ReportOptions;

constexpr OptionRow<ReportArgs> kReportRows[] = {
    {"--json", "FILE", kWork, "Verdicts, findings and doubts, JSON", store<&ReportArgs::json>},
    {"--sarif", "FILE", kWork, "Findings and doubts, SARIF 2.1.0", store<&ReportArgs::sarif>},
    {"--junit", "FILE", kWork, "Suite per program, case per rule, JUnit XML",
     store<&ReportArgs::junit>},
    {"--write-baseline", "FILE", kWork, "Findings of this run as known ones, for --baseline",
     store<&ReportArgs::write_baseline>},
    {"--github", "", kWork, "Findings as annotations of GitHub Actions",
     store<&ReportArgs::github>},
    {"--exit-zero", "", kWork, "Exit with 0 despite findings and doubts",
     store<&ReportArgs::exit_zero>},
    {"--notes", "", kText, "Print notes, too", store<&ReportArgs::notes>},
    {"--quiet,-q", "", kText, "Print findings and doubts only", store<&ReportArgs::quiet>}};

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
