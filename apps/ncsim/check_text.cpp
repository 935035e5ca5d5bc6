// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_text.h"

#include "check_outputs.h"
#include "findings.h"
#include "sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

namespace ncsim::app {

namespace {

using verify::Finding;
using verify::Severity;

// The line, cut to what a terminal shows, with the span marked below.
void put_excerpt(std::string& text, const std::string& line, gcode::SourceSpan span) {
    constexpr std::size_t kWidth = 100;
    if (line.empty()) return;
    std::size_t column = std::min<std::size_t>(std::max(span.column, 1U) - 1, line.size());
    const std::size_t first = column > kWidth * 3 / 4 ? column - kWidth / 2 : 0;
    const std::string shown = printable(std::string_view(line).substr(first, kWidth));
    column -= first;
    const std::size_t room = shown.size() > column ? shown.size() - column : 1;
    text += shown;
    text += '\n';
    text.append(column, ' ').append(1, '^');
    text.append(std::clamp<std::size_t>(span.length, 1, room) - 1, '~').append(1, '\n');
}

void put_finding(std::string& text, const Checked& checked, const Finding& f,
                 const std::string& line) {
    auto out = std::back_inserter(text);
    // As it was given, so that a click in a terminal finds it.
    text += f.place.file == 0 ? checked.path : file_of(checked, f.place);
    if (f.place.span.line > 0) {
        fmt::format_to(out, ":{}:{}", f.place.span.line, f.place.span.column);
    }
    fmt::format_to(out, ": {}: {}", verify::name_of(f.severity), headline(f));
    fmt::format_to(out, " [{}{}{}]\n", f.rule, f.code.empty() ? "" : ":", f.code);
    put_excerpt(text, line, f.place.span);
    if (f.count > 1 && f.last_motion > 0 && f.rule != "air-cut") {
        if (f.last.span.line == f.place.span.line) {
            fmt::format_to(out, "  in {} motions of this line\n", f.count);
        } else {
            fmt::format_to(out, "  in {} motions, the last one at line {}\n", f.count,
                           f.last.span.line);
        }
    } else if (f.count > 1 && f.last_motion == 0) {
        fmt::format_to(out, "  {} times, first here\n", f.count);
    }
    for (const std::string& assumption : f.assumptions)
        fmt::format_to(out, "  assumed {}\n", assumption);
    if (f.last_motion > 0) fmt::format_to(out, "  hint: {}\n", f.hint);
}

// Rules that could not be asked for the same reason share a line.
void put_skipped(std::string& text, const std::vector<verify::Skipped>& skipped) {
    std::vector<std::string_view> told;
    for (const verify::Skipped& s : skipped) {
        if (std::ranges::find(told, s.reason) != told.end()) continue;
        told.push_back(s.reason);
        std::string rules;
        for (const verify::Skipped& same : skipped) {
            if (same.reason == s.reason) rules += (rules.empty() ? "" : ", ") + same.rule;
        }
        fmt::format_to(std::back_inserter(text), "  skipped  {}: {}\n", rules, s.reason);
    }
}

std::string counted(std::uint64_t n, const char* what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

}  // namespace

std::string text_of(const Checked& checked, const CheckOptions& options) {
    std::string text;
    auto out = std::back_inserter(text);
    if (!checked.failure.empty()) {
        fmt::format_to(out, "{}: not verified: {}\n", checked.path, checked.failure);
        return printable(text);
    }
    const verify::Verdict& v = checked.verdict;
    for (std::size_t i = 0; i < v.findings.size(); ++i) {
        const Finding& f = v.findings[i];
        if (f.suppressed || (f.severity == Severity::Note && !options.notes)) continue;
        put_finding(text, checked, f, checked.lines[i]);
    }
    for (const auto& [rule, more] : v.unlisted) {
        fmt::format_to(out, "{}: {} more findings of {} are not listed\n", checked.path, more,
                       rule);
    }
    if (options.quiet) return printable(text);
    fmt::format_to(
        out, "{}: {}: {}, {}, {}", checked.path, checked.exit_code == kClean ? "clean" : "failed",
        counted(v.count(Severity::Error), "error"), counted(v.count(Severity::Warning), "warning"),
        counted(v.count(Severity::Note), "note"));
    if (v.suppressed() > 0) fmt::format_to(out, ", {} suppressed", v.suppressed());
    text += '\n';
    if (!checked.stock.empty()) fmt::format_to(out, "  stock    {}\n", checked.stock);
    if (checked.design) fmt::format_to(out, "  design   {}\n", text_of(*checked.design));
    put_skipped(text, v.skipped);
    return printable(text);
}

std::string summary_of(std::span<const Checked> all) {
    std::uint64_t clean = 0, failed = 0, broken = 0;
    for (const Checked& checked : all) {
        if (!checked.failure.empty()) {
            ++broken;
        } else if (checked.exit_code == kClean) {
            ++clean;
        } else {
            ++failed;
        }
    }
    return fmt::format("{}: {} clean, {} failed, {} not verified\n", counted(all.size(), "program"),
                       clean, failed, broken);
}

std::string rules_text() {
    std::string text;
    auto out = std::back_inserter(text);
    std::string_view category;
    for (const verify::RuleInfo& rule : verify::rules()) {
        if (verify::name_of(rule.category) != category) {
            category = verify::name_of(rule.category);
            fmt::format_to(out, "{}{}\n", text.empty() ? "" : "\n", category);
        }
        fmt::format_to(out, "  {:<20} {:<8} {}\n  {:<20} {:<8} {}\n", rule.id,
                       verify::name_of(rule.severity), rule.why, "", "", rule.fix);
    }
    return text;
}

std::string rules_json() {
    auto json = nlohmann::ordered_json::array();
    for (const verify::RuleInfo& rule : verify::rules()) {
        json.push_back({{"id", rule.id},
                        {"category", verify::name_of(rule.category)},
                        {"severity", verify::name_of(rule.severity)},
                        {"why", rule.why},
                        {"fix", rule.fix}});
    }
    return json.dump(1) + "\n";
}

}  // namespace ncsim::app
