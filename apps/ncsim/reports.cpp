// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports.h"

#include "ncsim/report/check_json.h"
#include "ncsim/report/check_text.h"
#include "ncsim/report/junit.h"
#include "ncsim/report/sarif.h"

#include "console.h"
#include "program_options.h"

#include <algorithm>
#include <ostream>

namespace ncsim::app {

namespace {

// Not proven stands between clean and faulty.
bool is_better(int a, int b) {
    const auto rank = [](int code) { return code == kNotProven ? 0.5 : code; };
    return rank(a) < rank(b);
}

}  // namespace

int exit_code_of(const report::Entries& all, bool exit_zero) {
    int worst = kClean;
    all([&](const report::Entry& entry) { worst = std::max(worst, entry.code, is_better); });
    const bool judged = worst == kFindings || worst == kNotProven;
    return judged && exit_zero ? int{kClean} : worst;
}

void Reports::tell(const report::Entry& entry) const {
    if (options_.github) {
        put_out(entry.github);
    } else {
        put_text(entry.text, outputs_.takes_standard_output());
    }
}

void Reports::write(const report::Entries& all) const {
    put_text(report::summary_of(all, {options_.notes, options_.quiet, many_}),
             outputs_.takes_standard_output());
    outputs_.write(options_.json, [&](std::ostream& out) { report::write_check_json(out, all); });
    outputs_.write(options_.sarif, [&](std::ostream& out) { report::write_sarif(out, all); });
    outputs_.write(options_.junit, [&](std::ostream& out) { report::write_junit(out, all); });
}

}  // namespace ncsim::app
