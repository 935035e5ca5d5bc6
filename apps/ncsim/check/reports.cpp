// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes reports about programs.
#include "check/reports.h"

#include "ncsim/report/check_json.h"
#include "ncsim/report/check_text.h"
#include "ncsim/report/junit.h"
#include "ncsim/report/sarif.h"
#include "ncsim/setup/input.h"

#include "options/job_steps.h"
#include "options/program_options.h"
#include "system/console.h"

#include <filesystem>
#include <ostream>
#include <system_error>

namespace ncsim::app {

int exit_code_of(const report::Entries& all, bool exit_zero) {
    int worst = kClean;
    all([&](const report::Entry& entry) { worst = worse_code(worst, entry.code); });
    const bool judged = worst == kFindings || worst == kNotProven;
    return judged && exit_zero ? int{kClean} : worst;
}

std::optional<report::Baseline> overwritten_baseline(const std::string& path) {
    // A separate set, because no output may be an input of the run.
    setup::InputSet aside;
    std::error_code ignored;
    if (path.empty() || path == "-" || !std::filesystem::is_regular_file(path, ignored))
        return std::nullopt;
    return report::Baseline(path, aside.read(path));
}

Reports::Reports(const ReportOptions& options, OutputSet& outputs, bool many)
    : options_(options),
      outputs_(outputs),
      many_(many),
      before_(overwritten_baseline(options.write_baseline)) {}

void Reports::add(const report::Entry& entry) const {
    if (options_.github) {
        write_stdout(entry.github);
    } else {
        put_text(entry.text, outputs_.takes_standard_output());
    }
}

void Reports::write(const report::Entries& all, const report::Scope& scope) const {
    put_text(report::summary_of(all, {options_.notes, options_.quiet, many_}, scope),
             outputs_.takes_standard_output());
    outputs_.write(options_.json,
                   [&](std::ostream& out) { report::write_check_json(out, all, scope); });
    outputs_.write(options_.sarif, [&](std::ostream& out) { report::write_sarif(out, all); });
    outputs_.write(options_.junit, [&](std::ostream& out) { report::write_junit(out, all); });
    outputs_.write(options_.write_baseline, [&](std::ostream& out) {
        report::write_baseline(out, options_.write_baseline, all, before_ ? &*before_ : nullptr);
    });
}

}  // namespace ncsim::app
