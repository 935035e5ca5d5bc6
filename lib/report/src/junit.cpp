// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts as JUnit XML.
#include "ncsim/report/junit.h"

#include "ncsim/base/file_names.h"
#include "ncsim/report/check_text.h"
#include "ncsim/verify/rule.h"

#include "append.h"
#include "json.h"
#include "markup.h"
#include "shares.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ostream>

namespace ncsim::report {

namespace {

using verify::Finding;
using verify::Severity;

// Returns text for XML 1.0: line ends are kept in attributes, and control characters and characters
// beyond ASCII become '?'.
std::string xml(std::string_view text) {
    std::string out;
    for (const char c : escaped(text)) {
        if (c == '\n') {
            out += "&#10;";
        } else {
            out += static_cast<unsigned char>(c) < 0x80 ? c : '?';
        }
    }
    return out;
}

struct Case {
    std::string_view rule;
    std::string skipped;
    std::string failures, remarks;  // a line for each finding
    std::size_t failed = 0;
};

std::string line_of(const Checked& checked, const Finding& f) {
    std::string text = file_of(checked, f.place);
    if (f.place.span.line > 0) {
        text += fmt::format(":{}:{}", f.place.span.line, f.place.span.column);
    }
    text += fmt::format(": {}: {}\n", verify::name_of(f.severity), headline(f));
    for (const std::string& assumption : f.assumptions)
        text += "  assumed " + assumption + "\n";
    return text;
}

std::string line_of(const Checked& checked, const verify::Doubt& d) {
    std::string text = file_of(checked, d.place);
    if (d.place.span.line > 0)
        text += fmt::format(":{}:{}", d.place.span.line, d.place.span.column);
    return text + fmt::format(": {}: {}\n", d.reason, d.message);
}

// Name of the additional case for all doubts.
constexpr std::string_view kProven = "proven";

std::vector<Case> cases_of(const Checked& checked, bool warnings_as_errors) {
    std::vector<Case> cases;
    for (const verify::RuleInfo& rule : verify::rules()) {
        Case one{rule.id, {}, {}, {}, 0};
        for (const verify::Skipped& s : checked.verdict.skipped) {
            if (s.rule == rule.id) one.skipped = s.reason;
        }
        for (const verify::Demotion& d : checked.verdict.demotions) {
            if (d.rule == rule.id) one.remarks += demotion_text(d) + '\n';
        }
        for (const Finding& f : checked.verdict.findings) {
            if (f.rule != rule.id) continue;
            const bool fails =
                f.counts() && (f.severity == Severity::Error ||
                               (warnings_as_errors && f.severity == Severity::Warning));
            (fails ? one.failures : one.remarks) += line_of(checked, f);
            if (fails) ++one.failed;
        }
        cases.push_back(std::move(one));
    }
    Case proven{kProven, {}, {}, {}, 0};
    for (const verify::Doubt& d : checked.verdict.doubts) {
        (d.accepted ? proven.remarks : proven.failures) += line_of(checked, d);
        if (!d.accepted) ++proven.failed;
    }
    cases.push_back(std::move(proven));
    return cases;
}

void put_case(std::string& text, const Case& c, const std::string& program) {
    append(text, "  <testcase classname=\"{}\" name=\"{}\" time=\"0\"", xml(program), c.rule);
    if (c.failures.empty() && c.remarks.empty() && c.skipped.empty()) {
        text += "/>\n";
        return;
    }
    text += ">\n";
    if (!c.failures.empty()) {
        append(text, "   <failure message=\"{} {}{}\" type=\"{}\">{}</failure>\n", c.failed,
               c.rule == kProven ? "doubt" : "finding", c.failed == 1 ? "" : "s", c.rule,
               xml(c.failures));
    } else if (!c.skipped.empty()) {
        append(text, "   <skipped message=\"{}\"/>\n", xml(c.skipped));
    }
    if (!c.remarks.empty()) append(text, "   <system-out>{}</system-out>\n", xml(c.remarks));
    text += "  </testcase>\n";
}

}  // namespace

Json junit_share(const Checked& checked, bool warnings_as_errors) {
    const std::string of_file = checked.program.empty() ? "" : " (" + checked.program + ')';
    const std::string program = relative_path(checked.path) + of_file;
    if (!checked.failure.empty()) {
        const std::string suite = fmt::format(
            " <testsuite name=\"{0}\" tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\" "
            "time=\"0\">\n  <testcase classname=\"{0}\" name=\"verified\" time=\"0\">\n"
            "   <error message=\"{1}\"/>\n  </testcase>\n </testsuite>\n",
            xml(program), xml(checked.failure));
        return {{"tests", 1}, {"failures", 0}, {"errors", 1}, {"skipped", 0}, {"suite", suite}};
    }
    const std::vector<Case> cases = cases_of(checked, warnings_as_errors);
    const auto failed =
        std::ranges::count_if(cases, [](const Case& c) { return !c.failures.empty(); });
    const auto passed_over = std::ranges::count_if(
        cases, [](const Case& c) { return c.failures.empty() && !c.skipped.empty(); });
    std::string suite = fmt::format(
        " <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\" "
        "time=\"0\">\n",
        xml(program), cases.size(), failed, passed_over);
    for (const Case& c : cases)
        put_case(suite, c, program);
    suite += " </testsuite>\n";
    return {{"tests", cases.size()},
            {"failures", failed},
            {"errors", 0},
            {"skipped", passed_over},
            {"suite", suite}};
}

void write_junit(std::ostream& out, const Entries& all) {
    std::array<std::uint64_t, 4> sums{};
    constexpr std::array<const char*, 4> kCounts{"tests", "failures", "errors", "skipped"};
    all([&](const Entry& entry) {
        const Json share = Json::parse(entry.junit);
        for (std::size_t i = 0; i < kCounts.size(); ++i)
            sums[i] += share[kCounts[i]].get<std::uint64_t>();
    });
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        << fmt::format(
               "<testsuites name=\"ncsim check\" tests=\"{}\" failures=\"{}\" errors=\"{}\" "
               "skipped=\"{}\" time=\"0\">\n",
               sums[0], sums[1], sums[2], sums[3]);
    all([&](const Entry& entry) {
        out << Json::parse(entry.junit)["suite"].get_ref<const std::string&>();
    });
    out << "</testsuites>\n";
}

}  // namespace ncsim::report
