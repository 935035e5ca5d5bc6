// SPDX-License-Identifier: GPL-3.0-or-later
#include "alternatives.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

namespace ncsim::simulation {

namespace {

verify::Place place_of(const gcode::ProgramPlace& place) {
    return {place.file, place.span};
}

// Key of a finding: rule, file, line.
using Row = std::tuple<std::string, std::uint32_t, std::uint32_t>;

Row row_of(const verify::Finding& finding) {
    return {finding.rule, finding.place.file, finding.place.span.line};
}

bool is_serious(const verify::Finding& finding) {
    return finding.severity != verify::Severity::Note && finding.counts();
}

// Returns: the most severe finding of `of` missing in `other`, or null.
const verify::Finding* missing_finding(const verify::Verdict& of, const verify::Verdict& other) {
    std::set<Row> known;
    for (const verify::Finding& f : other.findings) {
        if (is_serious(f)) known.insert(row_of(f));
    }
    const verify::Finding* worst = nullptr;
    for (const verify::Finding& f : of.findings) {
        if (!is_serious(f) || known.contains(row_of(f))) continue;
        if (!worst || f.severity > worst->severity) worst = &f;
    }
    return worst;
}

std::string described(const verify::Finding& finding) {
    return fmt::format("{} in line {}", finding.rule, finding.place.span.line);
}

}  // namespace

std::vector<Alternative> alternatives_to(const Plan& plan, const Survey& survey) {
    std::vector<Alternative> found;
    const setup::JobOptions& options = plan.job.options;
    const gcode::Interpretation& read = survey.interpretation;
    if (read.deletable && !options.block_delete) {
        found.push_back({"block-delete", "with blocks that start with '/' skipped",
                         place_of(*read.deletable), [](Plan& other, Questions&) {
                             other.job.options.block_delete = true;
                             other.job.interpreter.block_delete = true;
                         }});
    }
    if (read.without_point && read.has_points && !options.increments) {
        found.push_back({"decimal-point",
                         "with numbers without a decimal point as least increments",
                         place_of(*read.without_point), [](Plan& other, Questions&) {
                             other.job.options.increments = true;
                             other.job.interpreter.least_increments = true;
                         }});
    }
    return found;
}

std::string difference(const report::Checked& verdict, const report::Checked& other) {
    if (const auto* f = missing_finding(other.verdict, verdict.verdict)) return described(*f);
    if (const auto* f = missing_finding(verdict.verdict, other.verdict))
        return "without " + described(*f);
    if (verdict.outcome == other.outcome) return {};
    for (const verify::Doubt& doubt : other.verdict.doubts) {
        if (!doubt.accepted) return fmt::format("{}, {}", other.word, doubt.reason);
    }
    return std::string(other.word);
}

std::optional<verify::Doubt> doubt_between(const report::Checked& verdict,
                                           const report::Checked& other,
                                           const Alternative& alternative) {
    const std::string found = difference(verdict, other);
    if (found.empty()) return std::nullopt;
    verify::Doubt doubt;
    doubt.reason = alternative.reason;
    doubt.message = fmt::format("the verdict is another one {}: {}", alternative.message, found);
    doubt.place = alternative.place;
    return doubt;
}

}  // namespace ncsim::simulation
